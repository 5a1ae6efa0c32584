//! Methods of integration by name.

use liftoff::method::{Dop853, Taylor};
use liftoff::prelude::*;
use liftoff::{Measurement, Precision};
use std::time::Duration;

/// A method of integration.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Integrator {
    /// [`Dop853`].
    Dop853,
    /// [`Taylor`].
    Taylor,
}

impl Integrator {
    /// All methods.
    pub const ALL: [Self; 2] = [Self::Dop853, Self::Taylor];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Dop853 => "dop853",
            Self::Taylor => "taylor",
        }
    }

    /// The method of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    pub(super) fn measure<M: BarSystem>(
        self,
        precision: &mut Precision<M>,
        tolerances: &[f64],
    ) -> Vec<Measurement> {
        match self {
            Self::Dop853 => precision.measure(Dop853, tolerances),
            Self::Taylor => precision.measure(Taylor, tolerances),
        }
    }
}

/// What of error against run time to measure.
#[derive(Clone, PartialEq, Debug)]
pub struct Asked {
    /// Methods in this order.
    pub methods: Vec<Integrator>,
    /// Relative tolerances.
    pub tolerances: Vec<f64>,
    /// Time for each method at each tolerance.
    pub measuring: Duration,
}

impl Default for Asked {
    /// Every method at 1e-3 … 1e-14.
    fn default() -> Self {
        let tolerances = (3..=14).map(|digits| format!("1e-{digits}").parse().unwrap_or(f64::NAN));
        Self {
            methods: Integrator::ALL.to_vec(),
            tolerances: tolerances.collect(),
            measuring: Duration::from_millis(20),
        }
    }
}
