//! Steps of a phase up to its first event.

use core::sync::atomic::Ordering;

use super::record::{Record, Seen};
use super::{Drive, End, Touch};
use crate::contact::{ContactError, refuse_singular};
use crate::guard::GuardError;
use crate::integrate::{Guards, StepError, Stepper};
use crate::model::{BarSystem, Form};
use crate::pivot::least_pivot;
use crate::singular::Loops;
use crate::watch::{Findings, Guard, StepView};

/// So often a phase with steps below [`CREEPING`] natural times is asked whether it creeps towards a singularity.
const STEPS: usize = 1024;
const CREEPING: f64 = 1e-9;
/// After so many of them in a row the step size is at its floor for all that a run can achieve.
const MOST_STEPS: usize = 4 * STEPS;

/// A step that is taken back is tried again at this part of its length, down to this part of the time.
const SHORTER: f64 = 0.125;
const SHORTEST: f64 = 1e-13;

/// How many steps in a row have been tiny.
#[derive(Default)]
struct Creeping(usize);

impl Creeping {
    /// Counts a step; the error of a state before which the steps only shrink.
    fn note<M: BarSystem, const N: usize>(
        &mut self,
        drive: &Drive<'_, M>,
        record: &Record<M, N>,
        (h, end): (f64, &[f64; N]),
    ) -> Result<Option<ContactError>, StepError> {
        self.0 = if h < CREEPING * drive.scene.scales.time { self.0 + 1 } else { 0 };
        if self.0 > MOST_STEPS {
            return Err(StepError::Floor { t: record.t1, h });
        }
        if self.0 == 0 || !self.0.is_multiple_of(STEPS) {
            return Ok(None);
        }
        let state = (record.phase.embed)(&drive.scene.constants, end);
        Ok(refuse_singular::<M>(&drive.scene.series, &state, record.phase.set).err())
    }
}

impl<M: BarSystem> Drive<'_, M> {
    /// Steps up to the first event, or to what keeps the phase from going on.
    pub(super) fn advance<const N: usize>(
        &mut self,
        record: &mut Record<M, N>,
        stepper: &mut dyn Stepper<f64, N>,
        loops: &mut Option<Loops>,
        touches: &mut Vec<Touch>,
    ) -> Result<End, StepError> {
        let least = least_pivot(self.tolerance);
        let mut creeping = Creeping::default();
        match loops.as_mut().map_or(Ok(None), |loops| loops.begin::<M>(self.scene, self.t, &self.state)) {
            Ok(None) => {}
            Ok(Some(first)) => stepper.progress_mut().jump(self.t, record.start, first),
            Err(joints) => return Ok(End::Loop(joints)),
        }
        while record.t1 < self.horizon {
            if self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
                return Ok(End::Cancelled);
            }
            let before = record.t1;
            self.step(record, stepper)?;
            match self.examine(record, stepper.guards(), touches) {
                Ok(None) => {}
                Ok(Some(guards)) => return Ok(End::Event(guards)),
                Err(_) if self.step_back(record, stepper) => continue,
                Err(error) => return Err(error),
            }
            let end = stepper.progress().state();
            if let Some(singular) = creeping.note(self, record, (record.t1 - before, end))? {
                return Ok(End::Singular(singular));
            }
            let phase = &record.phase;
            let closed = phase.form == Form::Closed && record.t1 < self.horizon;
            if closed && (phase.pivot)(&self.scene.constants, end) < least {
                return Ok(End::Pivot);
            }
            if let Some(loops) = loops
                && let Some(end) = self.pass_singular(record, stepper, loops, touches)?
            {
                return Ok(end);
            }
        }
        Ok(End::Horizon)
    }

    /// One step, back on the constraints, recorded.
    fn step<const N: usize>(
        &self,
        record: &mut Record<M, N>,
        stepper: &mut dyn Stepper<f64, N>,
    ) -> Result<(), StepError> {
        let phase = &record.phase;
        stepper.progress_mut().allow_step(record.t1 - record.t0);
        stepper.step()?;
        if phase.form == Form::Projected {
            let mut state = (phase.embed)(&self.scene.constants, stepper.progress().state());
            self.project(phase, &mut state);
            stepper.amend((phase.restrict)(&state))?;
        }
        match self.is_unseen(record) {
            true => (record.t1, record.tip) = (stepper.progress().time(), *stepper.progress().state()),
            false => record.push(stepper.dense()),
        }
        Ok(())
    }

    /// Whether nobody looks into the steps, so that only their ends are needed.
    fn is_unseen<const N: usize>(&self, record: &Record<M, N>) -> bool {
        self.watches.is_empty() && !record.keeps && self.observer.is_blind()
    }

    /// Takes the last step back, for a shorter one; false if it was as short as can be. A guard that is not finite
    /// somewhere in a step may have its event before, one that turns too often in it to be followed has fewer turns in a part.
    fn step_back<const N: usize>(
        &self,
        record: &mut Record<M, N>,
        stepper: &mut dyn Stepper<f64, N>,
    ) -> bool {
        let Some(step) = record.steps.last() else { return false };
        let (t0, y0, h) = (step.t0, step.at(0.0), SHORTER * step.h);
        if h < SHORTEST * self.scene.scales.time.max(t0.abs()) {
            return false;
        }
        record.pop();
        stepper.progress_mut().jump(t0, y0, h);
        true
    }

    /// The guards of the first event of the last step, if there is one; the record ends there.
    fn examine<const N: usize>(
        &mut self,
        record: &mut Record<M, N>,
        guards: Option<Guards>,
        touches: &mut Vec<Touch>,
    ) -> Result<Option<Vec<Guard>>, StepError> {
        let Some(dense) = record.steps.last() else { return Ok(None) };
        let places = &record.places;
        let view = StepView { phase: &record.phase, scene: self.scene, dense, guards, places };
        let at = |theta: f64| dense.t0 + theta * dense.h;
        let told = |error| match error {
            GuardError::NotFinite { theta } => StepError::NotFinite { t: at(theta) },
            GuardError::Unresolved { theta } => StepError::Unresolved { t: at(theta) },
        };
        let Findings { touches: touched, first } =
            self.watches.examine(&view, dense.t1 >= self.horizon).map_err(told)?;
        record.t1 = match &first {
            Some((theta, _)) if *theta < 1.0 => at(*theta),
            _ => dense.t1,
        };
        touches.extend(touched.into_iter().map(|(theta, guard)| {
            let t = dense.t0 + theta * dense.h;
            let (state, reactions) = record.state_and_reactions(self.scene, t);
            let undecided = self.watches.is_undecided(guard, &reactions);
            Touch { t, guard, undecided, state, reactions }
        }));
        self.observer.step(&Seen { record, scene: self.scene });
        Ok(first.map(|(_, guards)| guards))
    }
}
