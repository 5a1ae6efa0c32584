//! Planar bar systems with one-sided supports: equations derived at compile time, contacts decided at run time.
//!
//! Declare a system with [`BarSystem`](macro@BarSystem), prepare a [`Simulation`], read its [`Trajectory`].

#[cfg(test)]
extern crate self as liftoff;

mod contact;
mod driver;
mod error;
mod event;
#[cfg(feature = "explain")]
mod explain;
pub mod figure;
pub mod guard;
pub mod integrate;
pub mod kernel;
pub mod model;
mod moment;
mod names;
mod output;
mod phase_handle;
mod project;
mod rest;
pub mod scalar;
mod scales;
mod segment;
mod simulation;
mod start;
mod trajectory;
mod watch;

pub use contact::ContactError;
pub use error::{ModelError, NameError, RunCause, RunError, StartError, SupportError};
pub use event::{Event, EventKind, Reaction};
#[cfg(feature = "explain")]
pub use explain::equations;
pub use liftoff_derive::BarSystem;
pub use model::BarSystem;
pub use output::{Condition, Output, OutputError};
pub use phase_handle::{PhaseHandle, Phases};
pub use simulation::Simulation;
pub use start::Pose;
pub use trajectory::{Extremum, LogEntry, Segment, Statistics, Trajectory};

/// What a program needs to declare, run and read a simulation.
pub mod prelude {
    pub use crate::model::Form;
    pub use crate::{
        BarSystem, Event, EventKind, Output, Phases, Pose, Reaction, RunError, Simulation, Trajectory,
    };
}
