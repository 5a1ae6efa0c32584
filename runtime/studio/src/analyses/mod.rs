//! What `liftoff-analysis` finds of models by name: the command line and Python ask here.
//!
//! - `rest`: equilibria, with how far a load may go; `vibration`: the linearised motion about a start.
//! - [`Failure`]: why there is no answer.

mod failure;
mod rest;
mod vibration;

pub use failure::Failure;
pub use rest::{Rest, find_equilibria, subject};
pub use vibration::{LinearHalves, describe_motion, find_contacts, linearise, linearise_halves};
