//! The models by name, with their types erased: what the command line and the report work with.

mod entry;
mod failure;
mod methods;
mod record;

pub(crate) use entry::run;
pub(crate) use failure::{input, stopped};

pub use failure::Failure;
pub use methods::{Asked, Integrator};

use crate::scene::Setup;
use liftoff::model::Layout;
use liftoff::prelude::*;
use liftoff::{Extremum, LogEntry, Measurement, Modes, Statistics};

/// A bar system that can be run by the names of things.
pub trait Model: Sync {
    /// Its name on the command line.
    fn name(&self) -> &'static str;
    /// What it is, in a line.
    fn summary(&self) -> &'static str;
    /// The names of its coordinates, supports and points.
    fn layout(&self) -> &'static Layout;
    /// Its default run.
    fn setup(&self) -> Setup;
    /// Its contact sets, with the parameters of the default run.
    fn modes(&self) -> Result<Modes, Failure>;
    /// Runs it.
    fn run(&self, setup: &Setup) -> Result<Box<dyn Record>, Failure>;
    /// Measures its error against its run time, method by method.
    fn precision(&self, setup: &Setup, asked: &Asked) -> Result<Vec<Measurement>, Failure>;
}

/// A motion with its model's type erased.
pub trait Record {
    /// The names of coordinates, supports and points.
    fn layout(&self) -> &'static Layout;
    /// What happened, from start to end.
    fn events(&self) -> &[Event];
    /// Times of the start and of the end.
    fn interval(&self) -> [f64; 2];
    /// Ends of the integrator's steps.
    fn times(&self) -> Vec<f64>;
    /// Coordinates, then rates, at a time.
    fn state(&self, t: f64) -> Vec<f64>;
    /// An output as a function of time.
    fn output<'a>(&'a self, text: &str) -> Result<Box<dyn Fn(f64) -> f64 + 'a>, Failure>;
    /// Where an output is largest and smallest, inside each smooth piece.
    fn extrema(&self, text: &str) -> Result<Vec<Extremum>, Failure>;
    /// Decisions that are no events.
    fn log(&self) -> &[LogEntry];
    /// Steps and evaluations.
    fn statistics(&self) -> Statistics;
}

/// Every model.
pub fn models() -> &'static [&'static dyn Model] {
    &entry::MODELS
}

/// The model of this name.
pub fn find(name: &str) -> Result<&'static dyn Model, Failure> {
    let found = models().iter().find(|model| model.name() == name);
    found.copied().ok_or_else(|| {
        let known: Vec<_> = models().iter().map(|model| model.name()).collect();
        Failure::Input(format!("no model `{name}`; there are {}", known.join(", ")))
    })
}
