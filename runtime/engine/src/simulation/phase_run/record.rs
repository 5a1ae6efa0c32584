//! A phase while it is recorded.

use std::sync::Arc;

use crate::context::{Numbers, RunContext};
use crate::expression::Output;
use crate::integration::method::Choice;
use crate::model::{ContactSet, Energy};
use crate::system::{DenseOutput, Phase};
use crate::trajectory::observe::Step;
use crate::trajectory::{RecordedPhase, Segment, Work};

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
        let recorded = RecordedPhase::new((phase, closed), t0, start.clone());
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
