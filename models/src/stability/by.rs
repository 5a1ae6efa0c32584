//! The methods that cases are integrated by.

use crate::catalog::{Failure, Record, simulation, stopped};
use crate::scene::{Scene, Setup};
use liftoff::method::{Dop853, Taylor};
use liftoff::prelude::*;

/// A method by its name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum By {
    /// Explicit Runge–Kutta of order 8.
    Dop853,
    /// Taylor series of variable order.
    Taylor,
}

impl By {
    /// Its name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dop853 => "dop853",
            Self::Taylor => "taylor",
        }
    }
}

impl By {
    /// The same simulation by this method.
    pub(super) fn of<M: BarSystem>(self, simulation: Simulation<M>) -> Simulation<M> {
        match self {
            Self::Dop853 => simulation.method(Dop853),
            Self::Taylor => simulation.method(Taylor),
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
