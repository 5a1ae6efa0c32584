//! The step across a singular position of a closed loop.

use super::record::Record;
use super::{Drive, End, Touch};
use crate::integrate::{Dense, StepError, Stepper};
use crate::model::BarSystem;
use crate::singular::{Ahead, Loops};
use crate::watch::{Guard, StepView};

impl<M: BarSystem> Drive<'_, M> {
    /// Looks out for singular positions of closed loops, and passes one that is near.
    pub(super) fn pass_singular<const N: usize>(
        &mut self,
        record: &mut Record<M, N>,
        stepper: &mut dyn Stepper<f64, N>,
        loops: &mut Loops,
        touches: &mut Vec<Touch>,
    ) -> Result<Option<End>, StepError> {
        let (scene, t) = (self.scene, record.t1);
        let embed = |y: &[f64; N]| (record.phase.embed)(&scene.constants, y);
        let h = record.steps.last().map_or(0.0, |step| step.h);
        let next = stepper.progress().next_step().unwrap_or(h);
        let ts = match loops.note::<M>(scene, (t, h, next), &embed(stepper.progress().state())) {
            Ahead::Here(ts) => ts,
            Ahead::Near(end) => {
                stepper.progress_mut().set_end(end.min(self.horizon));
                return Ok(None);
            }
            Ahead::Regular => {
                stepper.progress_mut().set_end(self.horizon);
                return Ok(None);
            }
        };
        stepper.progress_mut().set_end(self.horizon);
        let since = record.crossings.last().copied().unwrap_or(record.t0);
        let Some(beyond) = loops.cross::<M>(scene, (since, t, ts), &|t| embed(&record.reduced(t))) else {
            return Ok(None);
        };
        let phase = &record.phase;
        let f = |y: &[f64; N]| (phase.derivative)(&scene.constants, phase.set, y);
        let ends = [*stepper.progress().state(), (phase.restrict)(&beyond.state)];
        let dense = Dense::cubic([t, beyond.t], ends, ends.each_ref().map(f));
        // Reactions are undetermined on the way.
        let found = self.watches.examine(&StepView::new(phase, scene, &dense), false).unwrap_or_default();
        let first = found.first.filter(|(_, guards)| !guards.iter().any(|g| matches!(g, Guard::Reaction(_))));
        record.push(&dense);
        record.crossings.push(ts);
        if let Some((theta, guards)) = first {
            record.t1 = t + theta * (beyond.t - t);
            touches.retain(|touch| touch.t < record.t1);
            return Ok(Some(End::Event(guards)));
        }
        record.t1 = beyond.t.min(self.horizon);
        if record.t1 >= self.horizon {
            return Ok(Some(End::Horizon));
        }
        stepper.progress_mut().jump(beyond.t, ends[1], 0.25 * loops.window());
        Ok(None)
    }
}
