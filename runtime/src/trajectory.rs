//! A motion as computed: phases with dense output, and events.

use core::fmt;
use std::rc::Rc;

use crate::event::Event;
use crate::guard;
use crate::integrate::Counts;
use crate::method::Choice;
use crate::model::{BarSystem, ContactSet, Form};
use crate::moment::{Moment, Scene, seen};
use crate::output::{Condition, Output};
use crate::segment::Piece;
use crate::watch::Guard;

pub use crate::guard::ExtremumKind;

/// A motion from its start to the event that ended it. Of a run that was only observed it has the events and the last
/// state, and no motion in between.
pub struct Trajectory<M: BarSystem> {
    pub(crate) scene: Rc<Scene<M>>,
    pub(crate) pieces: Vec<Box<dyn Piece<M>>>,
    /// The guards that ended each piece; none where a planned time did.
    pub(crate) ends: Vec<Vec<Guard>>,
    pub(crate) conditions: Vec<Condition>,
    pub(crate) blows: Vec<Blow>,
    pub(crate) events: Vec<Event>,
    pub(crate) log: Vec<LogEntry>,
    pub(crate) statistics: Statistics,
    pub(crate) tolerance: f64,
    pub(crate) end: f64,
    pub(crate) last: Vec<f64>,
}

/// An impulse that was applied.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Blow {
    pub(crate) t: f64,
    pub(crate) point: usize,
    pub(crate) impulse: [f64; 2],
}

/// A decision of the simulation that is no event of the motion.
#[derive(Debug, Clone, PartialEq)]
pub struct LogEntry {
    /// When.
    pub t: f64,
    /// What.
    pub text: String,
}

/// The work that a run took.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Statistics {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the equations of motion by the integrator.
    pub evaluations: u64,
    /// Evaluations of their Jacobian.
    pub jacobians: u64,
}

impl Statistics {
    pub(crate) fn add(&mut self, counts: Counts) {
        self.steps += counts.accepted;
        self.rejected += counts.rejected;
        self.evaluations += counts.evaluations;
        self.jacobians += counts.jacobians;
    }
}

/// A part of a motion with one set of closed contacts.
#[derive(Debug, Clone, PartialEq)]
pub struct Segment {
    /// The closed contacts.
    pub set: ContactSet,
    /// Their supports.
    pub closed: Vec<&'static str>,
    /// In which form it was integrated.
    pub form: Form,
    /// By which method, and why by that.
    pub choice: Choice,
    /// Its start.
    pub t0: f64,
    /// Its end.
    pub t1: f64,
}

/// A turning point of an output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremum {
    /// When.
    pub t: f64,
    /// The value there.
    pub value: f64,
    /// Whether it is a minimum.
    pub minimum: bool,
}

impl<M: BarSystem> Trajectory<M> {
    pub(crate) fn empty(scene: Rc<Scene<M>>, tolerance: f64, last: Vec<f64>) -> Self {
        Self {
            scene,
            pieces: Vec::new(),
            ends: Vec::new(),
            conditions: Vec::new(),
            blows: Vec::new(),
            events: Vec::new(),
            log: Vec::new(),
            statistics: Statistics::default(),
            tolerance,
            end: 0.0,
            last,
        }
    }

    /// What happened, in order of time; the last event ended the run.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The phases in order of time.
    pub fn segments(&self) -> Vec<Segment> {
        self.pieces.iter().map(|piece| piece.segment()).collect()
    }

    /// Time of the start.
    pub fn start_time(&self) -> f64 {
        self.pieces.first().map_or(0.0, |piece| piece.segment().t0)
    }

    /// Time of the end.
    pub fn end_time(&self) -> f64 {
        self.end
    }

    /// The full state at a time, coordinates then rates; at the nearer end for times outside the run.
    pub fn state(&self, t: f64) -> Vec<f64> {
        self.at(t, |moment| seen::<M>(moment.state()).to_vec()).unwrap_or_else(|| self.last.clone())
    }

    /// An output at a time; NaN if nothing was computed. At an event it has the value after it.
    pub fn value(&self, output: &Output, t: f64) -> f64 {
        self.at(t, |moment| output.evaluate(&self.scene, moment)).unwrap_or(f64::NAN)
    }

    /// The full state at the end.
    pub fn final_state(&self) -> Vec<f64> {
        self.last.clone()
    }

    /// Ends of the integrator's steps in order of time; between two neighbours the motion is one polynomial.
    pub fn times(&self) -> Vec<f64> {
        let mut times: Vec<f64> = self.pieces.iter().flat_map(|piece| piece.times()).collect();
        times.dedup();
        times
    }

    /// The turning points of an output, in order of time; those that stand out by less than the error bound do not count.
    pub fn extrema(&self, output: &Output) -> Vec<Extremum> {
        let largest = self.times().iter().fold(0.0, |most: f64, &t| most.max(self.value(output, t).abs()));
        let delta = (10.0 * self.tolerance).max(64.0 * f64::EPSILON) * largest;
        let mut found = Vec::new();
        for piece in &self.pieces {
            for span in piece.times().windows(2) {
                let [t0, t1] = [span[0], span[1]];
                let at = |theta: f64| t0 + theta * (t1 - t0);
                let read = |moment: &dyn Moment<M>| output.evaluate(&self.scene, moment);
                let value = |theta: f64| self.within(piece.as_ref(), at(theta), read).unwrap_or(f64::NAN);
                // An output that is not finite somewhere in a step, tan φ say, has its turning points elsewhere.
                let _ = guard::extrema(value, delta, |extremum| {
                    let minimum = extremum.kind == ExtremumKind::Minimum;
                    found.push(Extremum { t: at(extremum.theta), value: extremum.value, minimum });
                });
            }
        }
        found
    }

    /// The least and the greatest value of an output over the run, at turning points and at the ends of steps, before and
    /// after events; none where nothing was computed or no value is finite.
    pub fn range(&self, output: &Output) -> Option<[f64; 2]> {
        let read = |moment: &dyn Moment<M>| output.evaluate(&self.scene, moment);
        let at = |piece: &dyn Piece<M>, t: f64| self.within(piece, t, read);
        let ends =
            self.pieces.iter().flat_map(|piece| piece.times().into_iter().map(|t| at(piece.as_ref(), t)));
        let turning = self.extrema(output).into_iter().map(|extremum| Some(extremum.value));
        let values = ends.chain(turning).flatten().filter(|value| value.is_finite());
        values.fold(None, |range: Option<[f64; 2]>, x| {
            Some(range.map_or([x, x], |[a, b]| [a.min(x), b.max(x)]))
        })
    }

    /// The work that the run took.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Decisions of the simulation that are no events: a change of form, say.
    pub fn log(&self) -> &[LogEntry] {
        &self.log
    }

    /// Parameters of the model, in declaration order.
    pub fn parameters(&self) -> &[f64] {
        &self.scene.parameters
    }

    fn at<T>(&self, t: f64, read: impl FnOnce(&dyn Moment<M>) -> T) -> Option<T> {
        let after = self.pieces.partition_point(|piece| piece.segment().t0 <= t);
        let piece = self.pieces.get(after.saturating_sub(1))?;
        self.within(piece.as_ref(), t, read)
    }

    fn within<T>(&self, piece: &dyn Piece<M>, t: f64, read: impl FnOnce(&dyn Moment<M>) -> T) -> Option<T> {
        let mut read = Some(read);
        let mut result = None;
        piece.at(&self.scene, t, &mut |moment| result = read.take().map(|read| read(moment)));
        result
    }
}

impl<M: BarSystem> fmt::Debug for Trajectory<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Trajectory").field("events", &self.events).finish_non_exhaustive()
    }
}
