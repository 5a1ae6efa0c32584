//! Methods of integration by name.

use crate::method::{Auto, Dop853, Gauss, Method, Radau, Taylor, Tsit5};
use crate::model::BarSystem;
use crate::names::unknown;
use crate::{Measurement, NameError, Precision, Simulation};
use core::str::FromStr;
use std::time::Duration;

/// A method of integration.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Integrator {
    /// What the product chooses: [`Auto`].
    Auto,
    /// Explicit Runge–Kutta of order 5: [`Tsit5`].
    Tsit5,
    /// Explicit Runge–Kutta of order 8: [`Dop853`].
    Dop853,
    /// Taylor series of variable order: [`Taylor`].
    Taylor,
    /// Radau IIA of order 5: [`Radau`].
    Radau,
    /// Gauss collocation of order 12: [`Gauss`].
    Gauss,
}

impl Integrator {
    /// All methods.
    pub const ALL: [Self; 6] =
        [Self::Auto, Self::Tsit5, Self::Dop853, Self::Taylor, Self::Radau, Self::Gauss];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => Auto.name(),
            Self::Tsit5 => Tsit5.name(),
            Self::Dop853 => Dop853.name(),
            Self::Taylor => Taylor.name(),
            Self::Radau => Radau.name(),
            Self::Gauss => Gauss.name(),
        }
    }

    /// The same simulation by this method.
    pub fn of<M: BarSystem>(self, simulation: Simulation<M>) -> Simulation<M> {
        match self {
            Self::Auto => simulation.method(Auto),
            Self::Tsit5 => simulation.method(Tsit5),
            Self::Dop853 => simulation.method(Dop853),
            Self::Taylor => simulation.method(Taylor),
            Self::Radau => simulation.method(Radau),
            Self::Gauss => simulation.method(Gauss),
        }
    }

    pub(super) fn measure<M: BarSystem>(
        self,
        precision: &mut Precision<M>,
        tolerances: &[f64],
    ) -> Vec<Measurement> {
        match self {
            Self::Auto => precision.measure(Auto, tolerances),
            Self::Tsit5 => precision.measure(Tsit5, tolerances),
            Self::Dop853 => precision.measure(Dop853, tolerances),
            Self::Taylor => precision.measure(Taylor, tolerances),
            Self::Radau => precision.measure(Radau, tolerances),
            Self::Gauss => precision.measure(Gauss, tolerances),
        }
    }
}

impl FromStr for Integrator {
    type Err = NameError;

    fn from_str(name: &str) -> Result<Self, NameError> {
        let known = Self::ALL.map(Self::name);
        Self::ALL
            .into_iter()
            .find(|method| method.name() == name)
            .ok_or_else(|| unknown("method", name, known))
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
