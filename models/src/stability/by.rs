//! The methods that cases are integrated by.

use crate::catalog::{Failure, Record, simulation, stopped};
use crate::scene::{Scene, Setup};
use liftoff::method::{Auto, Dop853, Gauss, Radau, Taylor};
use liftoff::prelude::*;

/// A method by its name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum By {
    /// Explicit Runge–Kutta of order 8.
    Dop853,
    /// Taylor series of variable order.
    Taylor,
    /// Radau IIA of order 5.
    Radau,
    /// Gauss collocation of order 12.
    Gauss,
    /// What the product chooses.
    Auto,
}

impl By {
    /// Its name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dop853 => "dop853",
            Self::Taylor => "taylor",
            Self::Radau => "radau",
            Self::Gauss => "gauss",
            Self::Auto => "auto",
        }
    }
}

impl By {
    /// The same simulation by this method.
    pub(super) fn of<M: BarSystem>(self, simulation: Simulation<M>) -> Simulation<M> {
        match self {
            Self::Dop853 => simulation.method(Dop853),
            Self::Taylor => simulation.method(Taylor),
            Self::Radau => simulation.method(Radau),
            Self::Gauss => simulation.method(Gauss),
            Self::Auto => simulation.method(Auto),
        }
    }
}

/// Runs a model.
pub(super) fn run<M: Scene>(by: By, setup: &Setup) -> Result<Box<dyn Record>, Failure> {
    match by.of(simulation::<M>(setup)?).run() {
        Ok(trajectory) => Ok(Box::new(trajectory)),
        Err(error) => Err(stopped(error)),
    }
}
