//! The step across a singular position of a closed loop.

use super::record::Recording;
use super::{PhaseRun, Termination, Touch};
use crate::event::detection::{Guard, StepView};
use crate::integrate::{DenseOutput, PhaseStepper, StepError};
use crate::integration::singular::{Continuation, Forecast, SingularityMonitor};
use crate::trajectory::{LogEntry, LoggedDecision};

impl PhaseRun<'_> {
    /// Looks out for singular positions of closed loops, and passes one that is near.
    pub(super) fn pass_singular(
        &mut self,
        recording: &mut Recording,
        stepper: &mut dyn PhaseStepper,
        loops: &mut SingularityMonitor,
        touches: &mut Vec<Touch>,
    ) -> Result<Option<Termination>, StepError> {
        let t = recording.t1();
        let h = recording.last().map_or(0.0, |step| step.h);
        let next = stepper.next_step().unwrap_or(h);
        let forecast = loops.note(self.context, (t, h, next), &self.embedded(stepper.state()));
        let end = if let Forecast::Near(end) = forecast { end.min(self.horizon) } else { self.horizon };
        stepper.set_end(end);
        let Forecast::Here(ts) = forecast else { return Ok(None) };
        let passed = |entry: &&LogEntry| entry.decision == LoggedDecision::SingularPosition;
        let since = self.log.iter().rev().find(passed).map_or(recording.t0(), |entry| entry.t);
        let at = |t: f64| {
            let mut reduced = vec![0.0; recording.start.len()];
            recording.reduced(t, &mut reduced);
            self.embedded(&reduced)
        };
        let Some(beyond) = loops.cross(self.context, (since, t, ts), &at) else { return Ok(None) };
        let dense = self.bridge((t, stepper.state()), &beyond);
        let step = StepView::new(&self.phase, self.context, &dense);
        // Reactions are undetermined on the way.
        let found = self.detector.examine(&step, false).unwrap_or_default();
        let first = found.first.filter(|(_, guards)| !guards.iter().any(|g| matches!(g, Guard::Reaction(_))));
        recording.next().clone_from(&dense);
        self.log.push(LogEntry { t: ts, decision: LoggedDecision::SingularPosition });
        if let Some((theta, guards)) = first {
            recording.end_at(t + theta * (beyond.t - t));
            touches.retain(|touch| touch.t < recording.t1());
            return Ok(Some(Termination::Event(guards)));
        }
        recording.end_at(beyond.t.min(self.horizon));
        if recording.t1() >= self.horizon {
            return Ok(Some(Termination::Horizon));
        }
        let mut reduced = vec![0.0; recording.start.len()];
        self.phase.restrict(&beyond.state, &mut reduced);
        stepper.jump(beyond.t, &reduced, 0.25 * loops.window());
        Ok(None)
    }

    fn embedded(&self, reduced: &[f64]) -> Vec<f64> {
        let mut state = vec![0.0; self.state.len()];
        self.phase.embed(reduced, &mut state);
        state
    }

    /// The cubic from a reduced state to a state beyond.
    fn bridge(&self, (t, here): (f64, &[f64]), beyond: &Continuation) -> DenseOutput {
        let mut there = vec![0.0; here.len()];
        self.phase.restrict(&beyond.state, &mut there);
        let slope = |y: &[f64]| {
            let mut slope = vec![0.0; y.len()];
            self.phase.derivative(y, &mut slope);
            slope
        };
        DenseOutput::cubic([t, beyond.t], [here, &there], [&slope(here), &slope(&there)])
    }
}
