//! A phase as dense output.

use std::sync::Arc;

use super::Segment;
use crate::context::{Numbers, RunContext, reduce};
use crate::event::supports;
use crate::integration::chart;
use crate::integration::method::Choice;
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Form};
use crate::system::{DenseOutput, PhaseEquations};

/// What a projection moves a state by at most, in natural units: some errors of a step at the
/// loosest tolerances.
const NEAR: f64 = 1e-3;

/// A phase that has been integrated.
pub(crate) struct RecordedPhase {
    pub(crate) phase: Arc<dyn PhaseEquations>,
    /// The closed contacts: those of the phase, and those that depend on them.
    closed: ContactSet,
    pub(crate) choice: Choice,
    /// All steps, or the last one.
    pub(crate) steps: Vec<DenseOutput>,
    pub(crate) t0: f64,
    pub(crate) t1: f64,
    /// The state at `t1`, where no step is kept.
    pub(crate) end_state: Numbers,
    /// Contacts that are held closed, and those that are no more.
    pub(crate) held: ContactSet,
    pub(crate) removed: ContactSet,
    /// Whether it begins with an impulse.
    pub(crate) is_struck: bool,
}

impl RecordedPhase {
    /// A phase that begins at a time in a reduced state, without steps.
    pub(crate) fn new(
        (phase, closed): (Arc<dyn PhaseEquations>, ContactSet),
        t0: f64,
        start: Numbers,
    ) -> Self {
        Self {
            phase,
            closed,
            choice: Choice { method: "none", why: "its integration did not begin" },
            steps: Vec::new(),
            t0,
            t1: t0,
            end_state: start,
            held: ContactSet::EMPTY,
            removed: ContactSet::EMPTY,
            is_struck: false,
        }
    }

    /// A phase of no duration in a full state.
    pub(crate) fn still(
        (phase, closed): (Arc<dyn PhaseEquations>, ContactSet),
        t: f64,
        state: &[f64],
    ) -> Self {
        let start = reduce(&*phase, state);
        Self::new((phase, closed), t, start)
    }

    /// Without contacts that only seemed to be closed.
    pub(crate) fn open(&mut self, parted: ContactSet) {
        self.closed = self.closed.difference(parted);
    }

    /// Set, form and times.
    pub(crate) fn segment(&self) -> Segment {
        let info = self.phase.info();
        let (set, closed) = (self.closed, supports(self.phase.system().layout(), self.closed));
        let bearing = info.set;
        let acting = self.acting();
        Segment {
            set,
            active_basis: bearing,
            closed,
            acting,
            form: info.form,
            choice: self.choice,
            t0: self.t0,
            t1: self.t1,
        }
    }

    /// The switched springs and loads that act, by their entries in the layout.
    fn acting(&self) -> Vec<usize> {
        let layout = self.phase.system().layout();
        let carried = self.phase.info().entries - layout.switches.len();
        (0..layout.switches.len()).filter(|i| self.end_state[carried + i] != 0.0).collect()
    }

    /// Ends of the steps, the start included.
    pub(crate) fn times(&self) -> impl Iterator<Item = f64> {
        self.steps.iter().map(|step| step.t0).chain([self.t1])
    }

    /// Start of the last step, and the end.
    pub(crate) fn last_times(&self) -> [f64; 2] {
        [self.steps.last().map_or(self.t0, |step| step.t0), self.t1]
    }

    /// The motion at a time, or at the nearer end.
    pub(crate) fn interpolate(&self, t: f64) -> PhasePoint {
        let t = t.clamp(self.t0, self.t1);
        let mut reduced = self.end_state.clone();
        self.reduced(t, &mut reduced);
        PhasePoint::new(Arc::clone(&self.phase), self.closed, t, reduced)
    }

    /// The motion at a time as it is read: within a step of a projected phase, whose ends alone are
    /// projected, on its constraints too.
    pub(crate) fn interpolate_on_constraints(&self, context: &RunContext, t: f64) -> PhasePoint {
        let (point, info) = (self.interpolate(t), self.phase.info());
        if info.form != Form::Multipliers || !self.is_within_step(t) {
            return point;
        }
        let mut state = point.state().to_vec();
        context.system().project(info.set, &mut state, context.scales.length);
        // At a singular position of a loop there is nothing to project onto.
        let [positions, rates] = chart::apart(context, point.state(), &state);
        if !(positions <= NEAR && rates <= NEAR) {
            return point;
        }
        let reduced = reduce(&*self.phase, &state);
        PhasePoint::new(Arc::clone(&self.phase), self.closed, point.t(), reduced)
    }

    fn is_within_step(&self, t: f64) -> bool {
        let after = self.steps.partition_point(|step| step.t0 <= t);
        let step = after.checked_sub(1).and_then(|k| self.steps.get(k));
        t < self.t1 && step.is_some_and(|step| step.t0 < t)
    }

    /// Moves a point of this phase to a time, or to the nearer end.
    pub(crate) fn show(&self, t: f64, point: &mut PhasePoint) {
        let t = t.clamp(self.t0, self.t1);
        point.move_to(t, |reduced| self.reduced(t, reduced));
    }

    /// The reduced state at a time, or at the nearer end.
    pub(crate) fn reduced(&self, t: f64, y: &mut [f64]) {
        let after = self.steps.partition_point(|step| step.t0 <= t);
        let Some(step) = self.steps.get(after.saturating_sub(1)) else {
            return y.copy_from_slice(&self.end_state);
        };
        let theta = (t.clamp(self.t0, self.t1) - step.t0) / step.h;
        step.interpolate(theta.clamp(0.0, 1.0), y);
    }
}
