//! A phase while it is recorded.

use std::sync::Arc;

use crate::context::{Numbers, RunContext};
use crate::expression::Output;
use crate::model::ContactSet;
use crate::system::{DenseOutput, PhaseEquations};
use crate::trajectory::observe::Step;
use crate::trajectory::{RecordedPhase, Segment};

/// A phase while it is integrated.
pub(super) struct Recording {
    pub(super) phase: RecordedPhase,
    keeps: bool,
    /// Bytes of all kept steps but the last.
    pub(super) memory: usize,
}

impl Recording {
    /// A phase that begins at a time in a state; it keeps all its steps or only the last.
    pub(super) fn new(
        (phase, closed): (Arc<dyn PhaseEquations>, ContactSet),
        (t0, start): (f64, Numbers),
        keeps: bool,
    ) -> Self {
        Self { phase: RecordedPhase::new((phase, closed), t0, start), keeps, memory: 0 }
    }

    /// Bytes of all that is kept.
    pub(super) fn whole_memory(&self) -> usize {
        self.memory + self.last().filter(|_| self.keeps).map_or(0, DenseOutput::memory)
    }

    pub(super) fn last(&self) -> Option<&DenseOutput> {
        self.phase.steps.last()
    }

    /// Room for the next step, that of the last one where only one is kept.
    pub(super) fn next(&mut self) -> &mut DenseOutput {
        let steps = &mut self.phase.steps;
        if self.keeps || steps.is_empty() {
            self.memory += steps.last().map_or(0, DenseOutput::memory);
            steps.push(DenseOutput::default());
        }
        let last = steps.len() - 1;
        &mut steps[last]
    }

    /// Goes on to a state without keeping the step.
    pub(super) fn skip_to(&mut self, t1: f64, state: &[f64]) {
        self.phase.t1 = t1;
        self.phase.end_state.copy_from_slice(state);
    }

    /// Removes the last step; it stays where only one is kept, since its start is still needed.
    pub(super) fn pop(&mut self) {
        if self.keeps {
            self.phase.steps.pop();
        }
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
        let point = self.recorded.interpolate_on_constraints(self.context, t);
        self.context.layout().public_state(point.state()).to_vec()
    }

    fn values(&self, outputs: &[Output], t: f64) -> Vec<f64> {
        let point = self.recorded.interpolate_on_constraints(self.context, t);
        outputs.iter().map(|output| output.evaluate(self.context, &point)).collect()
    }
}
