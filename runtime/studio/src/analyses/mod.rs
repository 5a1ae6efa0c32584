//! What `liftoff-analysis` finds of models by name: the command line and Python ask here.
//!
//! - `rest`: equilibria, with how far a load may go; `vibration`: the linearised motion about a
//!   start.
//! - [`Orbits`]: periodic orbits.
//! - `variables`: parameters and starts as what runs are varied with; `sensitivity`, [`optimise`],
//!   [`fit`] vary them.
//! - [`Measured`]: what is fitted; [`MeasuredTable`]: series of a file.
//! - [`Failure`]: why there is no answer.

mod failure;
mod fit;
mod measured;
mod optimum;
mod orbit;
mod rest;
mod sensitivity;
mod table;
mod variables;
mod vibration;

pub use failure::{Failure, describe_stop};
pub use fit::fit;
pub use measured::{Measured, MeasuredEvent};
pub use optimum::{Bounded, Goal, optimise};
pub use orbit::Orbits;
pub use rest::{Rest, find_equilibria, subject};
pub use sensitivity::{DifferentiatedRun, differentiate};
pub use table::{MeasuredTable, check_deviation};
pub use variables::VariableError;
pub use vibration::{LinearHalves, describe_motion, find_contacts, linearise, linearise_halves};

use crate::registry::Entry;
use liftoff::NameError;
use liftoff_core::model::Layout;
use liftoff_core::scalar::Dual4;
use liftoff_core::system::ModelOn;

/// The equations of a model on values with derivatives, given those of the parameters.
fn equations(model: &Entry, parameters: &[Dual4]) -> Result<ModelOn<Dual4>, String> {
    model.varied(parameters).map_err(|error| error.to_string())
}

/// The place of a parameter.
///
/// # Errors
/// There is none of this name.
pub fn find_parameter(layout: &Layout, name: &str) -> Result<usize, NameError> {
    let names = || layout.parameters.iter().copied();
    names().position(|known| known == name).ok_or_else(|| NameError::new("parameter", name, names()))
}

/// The place of a coordinate.
fn find_coordinate(layout: &Layout, name: &str) -> Result<usize, NameError> {
    let names = || layout.coordinates.iter().map(|coordinate| coordinate.name);
    names().position(|known| known == name).ok_or_else(|| NameError::new("coordinate", name, names()))
}
