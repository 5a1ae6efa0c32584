//! Observers of a run in progress.

use super::Segment;
use crate::event::Event;
use crate::expression::Output;

/// Sees each step of a run as it is made.
pub trait Observer {
    /// Whether the motion is to be kept as a trajectory.
    #[doc(hidden)]
    fn records(&self) -> bool {
        false
    }

    /// Whether it looks at no step.
    #[doc(hidden)]
    fn is_blind(&self) -> bool {
        false
    }

    /// Something happens at a time. It is told before the step is shown that holds this time or
    /// begins there: the motion after the event is that of the step that begins there, or of the
    /// end of the run.
    fn event(&mut self, t: f64) {
        let _ = t;
    }

    /// Velocities jump at the end of this step, which has been shown: its end is the motion before
    /// the event. It is told after [`event`](Self::event), for each of several impacts at one time
    /// with the motion before the first.
    fn jump(&mut self, before: &dyn Step) {
        let _ = before;
    }

    /// A step, or the part of one before an event.
    fn step(&mut self, step: &dyn Step);

    /// An event in full, after the step that it ended, when nothing that follows changes it any
    /// more. Whether the observer has taken it: then the trajectory does not keep it, and a run of
    /// any number of events needs no more memory. The first event and those that end the run are
    /// kept even so.
    fn happened(&mut self, event: &Event) -> bool {
        let _ = event;
        false
    }
}

/// The motion over one step.
pub trait Step {
    /// Times of its start and its end.
    fn times(&self) -> [f64; 2];
    /// The phase that it is a step of, from its start to the end of this step.
    fn phase(&self) -> Segment;
    /// The full state at a time between them: coordinates, then rates.
    fn state(&self, t: f64) -> Vec<f64>;
    /// Outputs at a time between them.
    fn values(&self, outputs: &[Output], t: f64) -> Vec<f64>;
}

impl Observer for () {
    fn is_blind(&self) -> bool {
        true
    }

    fn step(&mut self, _: &dyn Step) {}
}

/// Keeps the motion.
pub(crate) struct Recorder;

impl Observer for Recorder {
    fn records(&self) -> bool {
        true
    }

    fn step(&mut self, _: &dyn Step) {}
}
