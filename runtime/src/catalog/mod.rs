//! Models by name, with their types erased: what the command line and reports work with.

mod behind;
mod covariance;
mod entry;
mod failure;
mod methods;
mod models;
mod power;
mod record;
mod still;
mod way;

pub use behind::{Behind, behind};
pub use covariance::Dimension;
pub(crate) use covariance::{of_coordinate, per};
#[cfg(feature = "sweep")]
pub(crate) use entry::simulation;
pub use entry::{Entry, run};
#[cfg(feature = "sweep")]
pub(crate) use failure::chain;
pub use failure::{Failure, input, stopped};
pub use methods::{Asked, Integrator};
pub use models::Models;
#[doc(hidden)]
pub use models::{Bare, Kind, Staged};
pub use still::Still;
pub use way::Way;

use crate::model::{ContactSet, Layout};
use crate::scene::Setup;
use crate::{Event, Extremum, LogEntry, Measurement, Modes, Segment, Statistics};
use core::ops::ControlFlow;

/// A bar system that can be run by the names of things.
pub trait Model: Send + Sync {
    /// Its name on the command line.
    fn name(&self) -> &str;
    /// What it is, in a line.
    fn summary(&self) -> &str;
    /// The names of its coordinates, supports and points.
    fn layout(&self) -> &'static Layout;
    /// Its default run.
    fn setup(&self) -> Setup;
    /// Where a run starts.
    fn still(&self, setup: &Setup) -> Result<Still, Failure>;
    /// Its contact sets, with the parameters of a run.
    fn modes(&self, setup: &Setup) -> Result<Modes, Failure>;
    /// Whether this is an output of the model; why not, if it is none.
    fn check(&self, output: &str) -> Result<(), Failure>;
    /// Runs it in this way.
    fn run_by(&self, way: Way, setup: &Setup) -> Result<Box<dyn Record>, Failure>;
    /// Measures its error against its run time, method by method and tolerance by tolerance, until `go_on` breaks; that is
    /// asked before each.
    fn measure(
        &self,
        setup: &Setup,
        asked: &Asked,
        go_on: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Vec<Measurement>, Failure>;
    /// The natural length, time and mass of a run: the units in which tolerances are absolute.
    fn units(&self, setup: &Setup) -> Result<[f64; 3], Failure>;
    /// The dimension of each parameter; none where the model has numbers with a dimension in it.
    fn dimensions(&self, setup: &Setup) -> Option<Vec<Dimension>>;
    /// How fast a phase gains energy at a state, by its equations.
    fn power(&self, setup: &Setup, set: ContactSet, t: f64, state: &[f64]) -> Result<f64, Failure>;

    /// Runs the members of a sweep.
    #[cfg(feature = "sweep")]
    fn sweep(&self, members: &crate::sweep::Members<'_>);

    /// Runs it by the method that the product chooses.
    fn run(&self, setup: &Setup) -> Result<Box<dyn Record>, Failure> {
        self.run_by(Way::default(), setup)
    }

    /// Measures all of its error against its run time.
    fn precision(&self, setup: &Setup, asked: &Asked) -> Result<Vec<Measurement>, Failure> {
        self.measure(setup, asked, &mut || ControlFlow::Continue(()))
    }
}

/// A motion with its model's type erased.
pub trait Record {
    /// The names of coordinates, supports and points.
    fn layout(&self) -> &'static Layout;
    /// What happened, from start to end.
    fn events(&self) -> &[Event];
    /// Times of the start and of the end.
    fn interval(&self) -> [f64; 2];
    /// The phases in order of time.
    fn segments(&self) -> Vec<Segment>;
    /// The model at a time.
    fn still(&self, t: f64) -> Still;
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
