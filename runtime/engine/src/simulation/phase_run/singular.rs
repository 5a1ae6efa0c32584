//! The step across a singular position of a closed loop.

use super::record::Recording;
use super::{PhaseRun, Termination, Touch};
use crate::context::reduce;
use crate::event::detection::{Guard, StepView};
use crate::integrate::StepError;
use crate::integration::singular::{Bridge, Forecast, SingularityMonitor};
use crate::system::PhaseStepper;
use crate::trajectory::{LogEntry, LoggedDecision};

/// The first step beyond, in units of the step across.
const BEYOND: f64 = 0.1;
/// Reactions are undetermined within this part of the step on both sides of the position.
const UNDETERMINED: f64 = 0.1;

impl PhaseRun<'_> {
    /// Looks out for singular positions where a loop starts, or where it goes on with a finer
    /// tolerance.
    pub(super) fn begin_loop(
        &mut self,
        recording: &mut Recording,
        stepper: &mut dyn PhaseStepper,
        loops: &mut SingularityMonitor,
        touches: &mut Vec<Touch>,
    ) -> Result<Option<Termination>, StepError> {
        if recording.phase.t1 > recording.phase.t0 {
            return self.pass_singular(recording, stepper, loops, touches);
        }
        match loops.begin(self.context, self.t, &self.state) {
            Ok(_) if self.refine(loops) => Ok(Some(Termination::Horizon)),
            Ok(forecast) => self.follow(recording, stepper, (loops, forecast), touches),
            Err(joints) => Ok(Some(Termination::Loop(joints))),
        }
    }

    /// Looks out for singular positions of closed loops, and passes one that is near.
    pub(super) fn pass_singular(
        &mut self,
        recording: &mut Recording,
        stepper: &mut dyn PhaseStepper,
        loops: &mut SingularityMonitor,
        touches: &mut Vec<Touch>,
    ) -> Result<Option<Termination>, StepError> {
        let t = recording.phase.t1;
        let next = stepper.next_step().unwrap_or(f64::INFINITY);
        let state = self.embedded(stepper.state());
        if !loops.keeps_energy(self.context, &state) {
            recording.phase.t1 = recording.last().map_or(t, |step| step.t0);
            return Ok(Some(Termination::Loop(loops.singular(self.context, &state))));
        }
        let forecast = loops.note(self.context, (t, next), &state);
        if self.refine(loops) {
            return Ok(Some(Termination::Horizon));
        }
        self.follow(recording, stepper, (loops, forecast), touches)
    }

    /// Takes the tolerance that a singular position which is near asks for; whether that is another
    /// one.
    fn refine(&mut self, loops: &SingularityMonitor) -> bool {
        let finer = self.tolerance.min(loops.tolerance());
        let before = core::mem::replace(&mut self.tolerance, finer);
        self.tolerance < before
    }

    fn follow(
        &mut self,
        recording: &mut Recording,
        stepper: &mut dyn PhaseStepper,
        (loops, mut forecast): (&mut SingularityMonitor, Forecast),
        touches: &mut Vec<Touch>,
    ) -> Result<Option<Termination>, StepError> {
        let t = recording.phase.t1;
        let state = self.embedded(stepper.state());
        while let Forecast::Here(passage) = forecast {
            if let Some(bridge) = loops.cross(self.context, (t, passage), &state) {
                return self.bridge(recording, stepper, (passage[0], &bridge), touches);
            }
            if loops.is_singular(self.context, &state) {
                return Ok(Some(Termination::Loop(loops.singular(self.context, &state))));
            }
            forecast = loops.note_failure(self.context, t, &state);
        }
        let end = if let Forecast::Until(end) = forecast { end.min(self.horizon) } else { self.horizon };
        stepper.set_end(end);
        Ok(None)
    }

    fn bridge(
        &mut self,
        recording: &mut Recording,
        stepper: &mut dyn PhaseStepper,
        (ts, bridge): (f64, &Bridge),
        touches: &mut Vec<Touch>,
    ) -> Result<Option<Termination>, StepError> {
        let [t0, t1] = bridge.t;
        let dense = bridge.dense(&*self.phase);
        let step = StepView::new(&self.phase, self.context, &dense).across();
        // What loads do within the step across is in the equations at its points alone.
        let unseen = StepView::new(&self.phase, self.context, &dense).with_series(None);
        let unseen = self.signals.find_unseen(&unseen, self.tolerance, true);
        let found = self.detector.examine(&step, false).unwrap_or_default();
        if self
            .detector
            .unresolved()
            .is_some_and(|guard| !matches!(guard, Guard::Reaction(_) | Guard::Side(..)))
        {
            self.progress.log.push(LogEntry { t: ts, decision: LoggedDecision::GuardUnresolved });
        }
        let near = |theta: f64| (t0 + theta * (t1 - t0) - ts).abs() < UNDETERMINED * (t1 - t0);
        let first = found.first.filter(|(theta, guards)| {
            !(near(*theta)
                && guards.iter().any(|guard| matches!(guard, Guard::Reaction(_) | Guard::Side(..))))
        });
        recording.next().clone_from(&dense);
        if unseen.is_some() {
            self.note_once(ts, LoggedDecision::LoadUnresolved);
        }
        if ts >= t0 {
            self.progress.log.push(LogEntry { t: ts, decision: LoggedDecision::SingularPosition });
        }
        if let Some((theta, guards)) = first {
            recording.phase.t1 = t0 + theta * (t1 - t0);
            touches.retain(|touch| touch.t < recording.phase.t1);
            self.show(recording);
            return Ok(Some(Termination::Event(guards)));
        }
        recording.phase.t1 = t1.min(self.horizon);
        self.show(recording);
        if recording.phase.t1 >= self.horizon {
            self.progress.bridged = true;
            return Ok(Some(Termination::Horizon));
        }
        stepper.jump(t1, &reduce(&*self.phase, &bridge.state), BEYOND * (t1 - t0));
        stepper.set_end(self.horizon);
        Ok(None)
    }

    /// The full state of a reduced one.
    pub(super) fn embedded(&self, reduced: &[f64]) -> Vec<f64> {
        let mut state = vec![0.0; self.state.len()];
        self.phase.embed(reduced, &mut state);
        state
    }
}
