//! A phase as dense output.

use std::sync::Arc;

use crate::audit::Work;
use crate::event::supports;
use crate::expression::Output;
use crate::integrate::DenseOutput;
use crate::integration::chart;
use crate::integration::method::Choice;
use crate::integration::phase_point::{Numbers, PhasePoint, RunContext};
use crate::model::{ContactSet, Energy, Form};
use crate::system::Phase;
use crate::trajectory::Segment;
use crate::trajectory::observe::Step;
use smallvec::smallvec;

/// What a projection moves a state by at most, in natural units: some errors of a step at the loosest tolerances.
const NEAR: f64 = 1e-3;

/// A phase that has been integrated.
pub(crate) struct RecordedPhase {
    pub(crate) phase: Arc<dyn Phase>,
    /// The closed contacts: those of the phase, and those that depend on them.
    closed: ContactSet,
    pub(crate) choice: Choice,
    /// All steps, or the last one.
    pub(crate) steps: Vec<DenseOutput>,
    pub(crate) t0: f64,
    pub(crate) t1: f64,
    /// The state at `t1`, where no step is kept.
    end_state: Numbers,
    /// Contacts that are held closed, and those that are no more.
    pub(crate) held: ContactSet,
    pub(crate) removed: ContactSet,
    /// Whether it begins with an impulse.
    pub(crate) is_struck: bool,
}

impl RecordedPhase {
    /// A phase of no duration.
    pub(crate) fn still((phase, closed): (Arc<dyn Phase>, ContactSet), t: f64, state: &[f64]) -> Self {
        let mut start: Numbers = smallvec![0.0; phase.info().entries];
        phase.restrict(state, &mut start);
        Recording::new((phase, closed), (t, start), false).recorded
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
            bearing,
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
    fn last_times(&self) -> [f64; 2] {
        [self.steps.last().map_or(self.t0, |step| step.t0), self.t1]
    }

    /// The motion at a time, or at the nearer end.
    pub(crate) fn at(&self, t: f64) -> PhasePoint {
        let t = t.clamp(self.t0, self.t1);
        let mut reduced = self.end_state.clone();
        self.reduced(t, &mut reduced);
        PhasePoint::new(Arc::clone(&self.phase), self.closed, t, reduced)
    }

    /// The motion at a time as it is read: within a step of a projected phase, whose ends alone are projected, on its constraints
    /// too.
    pub(crate) fn read(&self, context: &RunContext, t: f64) -> PhasePoint {
        let (point, info) = (self.at(t), self.phase.info());
        if info.form != Form::Projected || !self.is_within_step(t) {
            return point;
        }
        let mut state = point.state().to_vec();
        context.system().project(info.set, &mut state, context.scales.length);
        // At a singular position of a loop there is nothing to project onto.
        let [positions, rates] = chart::apart(context, point.state(), &state);
        if !(positions <= NEAR && rates <= NEAR) {
            return point;
        }
        let mut reduced: Numbers = smallvec![0.0; info.entries];
        self.phase.restrict(&state, &mut reduced);
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
    fn reduced(&self, t: f64, y: &mut [f64]) {
        let after = self.steps.partition_point(|step| step.t0 <= t);
        let Some(step) = self.steps.get(after.saturating_sub(1)) else {
            return y.copy_from_slice(&self.end_state);
        };
        let theta = (t.clamp(self.t0, self.t1) - step.t0) / step.h;
        step.at(theta.clamp(0.0, 1.0), y);
    }
}

/// A phase while it is integrated.
pub(super) struct Recording {
    recorded: RecordedPhase,
    keeps: bool,
    /// Bytes of all kept steps but the last.
    memory: usize,
    /// The reduced state at the start.
    pub(super) start: Numbers,
}

impl Recording {
    /// A phase that begins at a time in a state; it keeps all its steps or only the last.
    pub(super) fn new(
        (phase, closed): (Arc<dyn Phase>, ContactSet),
        (t0, start): (f64, Numbers),
        keeps: bool,
    ) -> Self {
        let choice = Choice { method: "none", why: "its integration did not begin" };
        let recorded = RecordedPhase {
            phase,
            closed,
            choice,
            steps: Vec::new(),
            t0,
            t1: t0,
            end_state: start.clone(),
            held: ContactSet::EMPTY,
            removed: ContactSet::EMPTY,
            is_struck: false,
        };
        Self { recorded, keeps, memory: 0, start }
    }

    /// Takes note of the method that integrates it.
    pub(super) fn choose(&mut self, choice: Choice) {
        self.recorded.choice = choice;
    }

    /// Bytes of what is kept, before the last step.
    pub(super) fn memory(&self) -> usize {
        self.memory
    }

    /// Bytes of all that is kept.
    pub(super) fn whole_memory(&self) -> usize {
        self.memory + self.last().filter(|_| self.keeps).map_or(0, DenseOutput::memory)
    }

    pub(super) fn t0(&self) -> f64 {
        self.recorded.t0
    }

    pub(super) fn t1(&self) -> f64 {
        self.recorded.t1
    }

    /// Ends the phase at a time, within its last step.
    pub(super) fn end_at(&mut self, t1: f64) {
        self.recorded.t1 = t1;
    }

    /// Start of the last step, and the end.
    pub(super) fn last_times(&self) -> [f64; 2] {
        self.recorded.last_times()
    }

    pub(super) fn last(&self) -> Option<&DenseOutput> {
        self.recorded.steps.last()
    }

    /// Room for the next step, that of the last one where only one is kept.
    pub(super) fn next(&mut self) -> &mut DenseOutput {
        let steps = &mut self.recorded.steps;
        if self.keeps || steps.is_empty() {
            self.memory += steps.last().map_or(0, DenseOutput::memory);
            steps.push(DenseOutput::default());
        }
        let last = steps.len() - 1;
        &mut steps[last]
    }

    /// Goes on to a state without keeping the step.
    pub(super) fn skip_to(&mut self, t1: f64, state: &[f64]) {
        self.recorded.t1 = t1;
        self.recorded.end_state.copy_from_slice(state);
    }

    /// Removes the last step; it stays where only one is kept, since its start is still needed.
    pub(super) fn pop(&mut self) {
        if self.keeps {
            self.recorded.steps.pop();
        }
    }

    /// The public state, energy, reactions and gaps at a time that is kept.
    pub(super) fn shown_at(
        &self,
        context: &RunContext,
        t: f64,
    ) -> (Vec<f64>, Energy<f64>, Vec<f64>, Vec<f64>) {
        let at = self.recorded.at(t);
        let mut gaps = vec![0.0; context.layout().contacts.len()];
        context.system().gaps(at.state(), &mut gaps);
        let state = context.layout().public_state(at.state()).to_vec();
        (state, at.energy(), at.reactions().to_vec(), gaps)
    }

    /// Adds the work of the last step, up to its end.
    pub(super) fn add_work(&self, context: &RunContext, work: &mut Work) {
        work.add(context, &self.recorded, self.last_times());
    }

    pub(super) fn reduced(&self, t: f64, y: &mut [f64]) {
        self.recorded.reduced(t, y);
    }

    pub(super) fn recorded(&self) -> &RecordedPhase {
        &self.recorded
    }

    pub(super) fn into_recorded(self) -> RecordedPhase {
        self.recorded
    }
}

/// The last step of a phase, up to its end.
pub(crate) struct LastStep<'a> {
    pub(crate) context: &'a RunContext,
    pub(crate) recorded: &'a RecordedPhase,
}

impl Step for LastStep<'_> {
    fn times(&self) -> [f64; 2] {
        self.recorded.last_times()
    }

    fn phase(&self) -> Segment {
        self.recorded.segment()
    }

    fn state(&self, t: f64) -> Vec<f64> {
        let point = self.recorded.read(self.context, t);
        self.context.layout().public_state(point.state()).to_vec()
    }

    fn values(&self, outputs: &[Output], t: f64) -> Vec<f64> {
        let point = self.recorded.read(self.context, t);
        outputs.iter().map(|output| output.evaluate(self.context, &point)).collect()
    }
}
