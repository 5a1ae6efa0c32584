//! Steps of a phase up to its first event.

use std::sync::atomic::Ordering;

use super::paradox::Border;
use super::record::{LastStep, Recording};
use super::{PhaseRun, Termination, Touch};
use crate::audit::{Finding, Seam, work_of};
use crate::contact::{ContactError, refuse_singular};
use crate::context::Numbers;
use crate::event::detection::{AffineGuards, Guard, StepEvents, StepView, Unseen};
use crate::integrate::{Counts, Guards, StepError};
use crate::integration::form_selection::{eliminates, least_pivot};
use crate::integration::singular::SingularityMonitor;
use crate::model::{ContactSet, Form, Pivots};
use crate::numerics::root_isolation::GuardError;
use crate::numerics::zero::SOLVED;
use crate::system::{DenseOutput, PhaseStepper};
use crate::trajectory::{LogEntry, LoggedDecision};
use smallvec::smallvec;

/// After each such number of consecutive steps below [`TINY`] natural times a phase is checked for
/// a singularity.
const STEPS: usize = 64;
const TINY: f64 = 1e-9;
/// After so many of them in a row the run stops: the step size is at its floor.
const MOST_STEPS: usize = 64 * STEPS;

/// After so many steps in a row that were rejected for an unresolved guard, each [`SHORTER`], it is
/// taken for noise.
const MOST_UNRESOLVED: u32 = 4;

/// After so many steps in a row that have not seen a load, each [`SHORTER`], what is left of it is
/// not proved to be small.
const MOST_UNSEEN: u32 = 8;

/// So much of the natural time, or of the time.
const UNSEEN: f64 = 1e-6;

/// A landing that is not seen for longer than this part of the natural time is told.
const LATE: f64 = 1e-3;

/// A rejected step is repeated with this fraction of its length
const SHORTER: f64 = 0.125;

/// How many steps in a row have been tiny.
#[derive(Default)]
struct Stagnation {
    steps: usize,
}

impl Stagnation {
    /// Counts a step, its length in natural times; whether it is time to check for a singularity.
    fn note(&mut self, natural: f64) -> bool {
        self.steps = if natural < TINY { self.steps + 1 } else { 0 };
        self.steps > 0 && self.steps.is_multiple_of(STEPS)
    }
}

impl<'a> PhaseRun<'a> {
    /// Steps up to the first event, or to what keeps the phase from going on.
    pub(super) fn advance(
        &mut self,
        recording: &mut Recording,
        stepper: &mut dyn PhaseStepper,
        loops: &mut Option<SingularityMonitor>,
        touches: &mut Vec<Touch>,
    ) -> Result<Termination, StepError> {
        let (least, begun) = (least_pivot(self.tolerance), self.pivots(stepper));
        let mut stagnation = Stagnation::default();
        let mut affine = None;
        if let Some(loops) = loops
            && let Some(end) = self.begin_loop(recording, stepper, loops, touches)?
        {
            return Ok(end);
        }
        while recording.phase.t1 < self.horizon {
            if self.limits.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
                return Ok(Termination::Cancelled);
            }
            let Counts { accepted, rejected, .. } = stepper.counts();
            if let Some(of) = self.limits.allowance.exceeded_by(accepted + rejected, recording.memory) {
                return Ok(Termination::Exhausted(of));
            }
            if accepted.is_power_of_two() {
                self.note_energy(stepper.state());
            }
            let before = recording.phase.t1;
            if let Some(jump) = self.step(recording, stepper)? {
                if self.step_back(recording, stepper) {
                    continue;
                }
                return Ok(Termination::Seam(jump));
            }
            // Near a singular elimination what it gives is off by a power of 1/p: the phase ends
            // where the step began that has come near it, or has passed it.
            let pivots = self.pivots(stepper);
            if pivots.least < least || pivots.negative != begun.negative {
                recording.pop();
                return Ok(Termination::Pivot);
            }
            match self.check_signals(recording, stepper) {
                Some(Unseen::Drive(broken)) => return Ok(Termination::Drive(broken)),
                Some(Unseen::Step) => continue,
                Some(Unseen::Lost) | None => {}
            }
            match self.look(recording, stepper, &mut affine, touches) {
                Ok(None) => self.progress.unresolved = 0,
                Ok(Some(guards)) => return Ok(Termination::Event(guards)),
                Err(error) => match self.shorten(error, recording, stepper)? {
                    None => continue,
                    Some(end) => return Ok(end),
                },
            }
            let t1 = recording.phase.t1;
            let h = t1 - before;
            if stagnation.note(h / self.context.scales.time) {
                if let Some(singular) = self.singular(stepper.state()) {
                    return Ok(Termination::Singular(singular));
                }
                if stagnation.steps >= MOST_STEPS {
                    return Err(StepError::Floor { t: t1, h });
                }
            }
            if let Some(loops) = loops
                && let Some(end) = self.pass_singular(recording, stepper, loops, touches)?
            {
                return Ok(end);
            }
        }
        Ok(Termination::Horizon)
    }

    /// The pivots where the steps have come to.
    fn pivots(&self, stepper: &dyn PhaseStepper) -> Pivots<f64> {
        if eliminates(&*self.phase) { self.phase.pivots(stepper.state()) } else { Pivots::collect([]) }
    }

    /// The break of a drive for which a step, or the guards over it, have failed.
    pub(super) fn break_near(&self, error: StepError) -> Option<Termination> {
        let (StepError::NotFinite { t } | StepError::Unresolved { t }) = error else { return None };
        self.signals.find_break_near(self.context, t).map(Termination::Drive)
    }

    /// What the last step has not seen of loads and drives; it is rejected then in favour of a
    /// shorter one.
    fn check_signals(&mut self, recording: &mut Recording, stepper: &mut dyn PhaseStepper) -> Option<Unseen> {
        let signals = &mut self.signals;
        let dense = recording.last().filter(|_| !signals.is_empty())?;
        let (t, natural) = (dense.t0, self.context.scales.time);
        let is_shortest = signals.unseen >= MOST_UNSEEN || dense.h < UNSEEN * natural.max(t.abs());
        let view = StepView::new(&self.phase, self.context, dense).with_series(None);
        let found = signals.find_unseen(&view, self.tolerance, is_shortest);
        match found {
            None | Some(Unseen::Lost) => {
                if core::mem::take(&mut signals.unseen) > 0 {
                    stepper.set_end(self.horizon);
                }
                if found.is_some() {
                    self.note_once(t, LoggedDecision::LoadUnresolved);
                }
            }
            Some(Unseen::Drive(_)) => recording.pop(),
            Some(Unseen::Step) => {
                signals.unseen += 1;
                let end = t + SHORTER * dense.h;
                if !self.step_back(recording, stepper) {
                    return None;
                }
                // A method of constant steps would make it longer again.
                stepper.set_end(end);
            }
        }
        found
    }

    /// The guards of the first event of the last step, if there is one, by series where these are
    /// known.
    fn look(
        &mut self,
        recording: &mut Recording,
        stepper: &mut dyn PhaseStepper,
        affine: &mut Option<&'a mut AffineGuards>,
        touches: &mut Vec<Touch>,
    ) -> Result<Option<Vec<Guard>>, StepError> {
        if !self.is_within_domain(stepper.state()) {
            return Err(StepError::NotFinite { t: recording.phase.t1 });
        }
        let own = stepper.guards();
        let is_fitted = own.is_none() && self.has_affine_guards();
        let series = if is_fitted { self.of_dense(affine, recording) } else { own };
        self.examine(recording, (series, is_fitted), touches)
    }

    fn has_affine_guards(&self) -> bool {
        self.phase.info().affine && !self.detector.is_empty()
    }

    /// The series that the last step's dense output makes of guards that are affine.
    fn of_dense<'g>(
        &mut self,
        affine: &'g mut Option<&'a mut AffineGuards>,
        recording: &Recording,
    ) -> Option<Guards<'g>> {
        if let Some(known) = self.affine.take() {
            *affine = Some(known.find_or_compute(&*self.phase, self.context));
        }
        affine.as_deref_mut()?.over(recording.last()?)
    }

    /// Whether functions of time, which are not integrated, are numbers at the end of a step.
    fn is_within_domain(&mut self, reduced: &[f64]) -> bool {
        if !self.context.layout().timed {
            return true;
        }
        self.phase.embed(reduced, &mut self.state);
        self.state.iter().all(|x| x.is_finite())
    }

    /// The size of the energy on the way, from a few states: the gate compares with it at the end.
    fn note_energy(&mut self, reduced: &[f64]) {
        self.phase.embed(reduced, &mut self.state);
        self.progress.work.note(&self.context.system().energy(&self.state));
    }

    /// The error that says so if the accelerations are nearly undetermined at this state, before
    /// which the steps shrink.
    fn singular(&self, end: &[f64]) -> Option<ContactError> {
        refuse_singular(&self.context.model, &self.embedded(end), self.phase.info().set).err()
    }

    /// Counts a step over which a guard was not resolved. If steps so much shorter do not resolve
    /// it either, it is taken for noise from now on.
    fn note_unresolved(&mut self, error: StepError) {
        let StepError::Unresolved { t } = error else { return };
        self.progress.unresolved += 1;
        if self.progress.unresolved == MOST_UNRESOLVED {
            self.detector.expect_noise();
            self.progress.log.push(LogEntry { t, decision: LoggedDecision::GuardUnresolved });
        }
    }

    pub(super) fn note_once(&mut self, t: f64, decision: LoggedDecision) {
        if self.progress.log.iter().all(|entry| entry.decision != decision) {
            self.progress.log.push(LogEntry { t, decision });
        }
    }

    /// Makes one step, projects its end onto the constraints and records it; where that would be a
    /// jump, which.
    fn step(
        &mut self,
        recording: &mut Recording,
        stepper: &mut dyn PhaseStepper,
    ) -> Result<Option<Finding>, StepError> {
        stepper.allow_step(recording.phase.t1 - recording.phase.t0);
        stepper.step()?;
        let (info, mut jump) = (self.phase.info(), None);
        if info.form == Form::Multipliers {
            self.phase.embed(stepper.state(), &mut self.state);
            let ahead = Numbers::from_slice(&self.state);
            self.context.system().project(info.set, &mut self.state, self.context.scales.length);
            let seam = Seam {
                context: self.context,
                t: stepper.time(),
                tolerance: self.tolerance,
                is_struck: false,
            };
            jump = seam.compare(&ahead, &self.state).into_iter().flatten().find(Finding::is_violation);
            let mut reduced = core::mem::take(&mut self.progress.reduced);
            reduced.resize(info.entries, 0.0);
            self.phase.restrict(&self.state, &mut reduced);
            let replaced = stepper.replace_end(&reduced);
            self.progress.reduced = reduced;
            replaced?;
        }
        if self.progress.is_unseen {
            recording.skip_to(stepper.time(), stepper.state());
        } else {
            stepper.dense(recording.next());
        }
        Ok(jump)
    }

    /// Takes note of the work of the last step, and shows it to the observer.
    pub(super) fn show(&mut self, recording: &Recording) {
        self.add_work(recording);
        self.observer.step(&LastStep { context: self.context, recorded: &recording.phase });
    }

    fn add_work(&mut self, recording: &Recording) {
        if !self.context.is_conservative() {
            let times = recording.phase.last_times();
            self.progress.work.add(self.context, &recording.phase, times);
        }
    }

    /// Rejects the last step, over which a guard was not resolved, in favour of a shorter one, or
    /// ends the phase at the border of Painlevé's region.
    fn shorten(
        &mut self,
        error: StepError,
        recording: &mut Recording,
        stepper: &mut dyn PhaseStepper,
    ) -> Result<Option<Termination>, StepError> {
        let border = self.border(recording, stepper);
        match border {
            Border::Reached => {
                recording.pop();
                return Ok(Some(Termination::Paradox));
            }
            Border::Within => {}
            Border::Elsewhere => self.note_unresolved(error),
        }
        if self.step_back(recording, stepper) {
            return Ok(None);
        }
        if let Border::Within = border {
            recording.pop();
        }
        Err(error)
    }

    /// Rejects the last step in favour of a shorter one; false if it was as short as possible. A
    /// guard that is not finite within a step may have its event before that; one that turns too
    /// often to be followed turns less often in a part of the step.
    fn step_back(&self, recording: &mut Recording, stepper: &mut dyn PhaseStepper) -> bool {
        let Some(step) = recording.last() else { return false };
        let (t0, y0, h) = (step.t0, step.start(), SHORTER * step.h);
        if h < SOLVED * self.context.scales.time.max(t0.abs()) {
            return false;
        }
        recording.pop();
        stepper.jump(t0, &y0, h);
        true
    }

    /// Whether the closed form is not to be trusted within a step, though it was at its start: what
    /// the guards have there is the error of the state by the third power of the pivot.
    fn is_nearly_singular(&self, dense: &DenseOutput, theta: f64) -> bool {
        if !eliminates(&*self.phase) {
            return false;
        }
        let mut reduced: Numbers = smallvec![0.0; dense.entries()];
        dense.interpolate(theta, &mut reduced);
        self.phase.pivots(&reduced).least < least_pivot(self.tolerance)
    }

    /// The same, given the series; the recording ends there.
    fn examine(
        &mut self,
        recording: &mut Recording,
        (series, is_fitted): (Option<Guards>, bool),
        touches: &mut Vec<Touch>,
    ) -> Result<Option<Vec<Guard>>, StepError> {
        let Some(dense) = recording.last() else { return Ok(None) };
        let (t0, t1, h) = (dense.t0, dense.t1, dense.h);
        let at = |theta: f64| t0 + theta * h;
        let view = StepView::new(&self.phase, self.context, dense).with_closed(self.closed);
        let view = view.with_series(series).with_fitted(is_fitted);
        let as_step = |error| match error {
            GuardError::NotFinite { theta } => StepError::NotFinite { t: at(theta) },
            GuardError::Unresolved { theta } => StepError::Unresolved { t: at(theta) },
        };
        let StepEvents { touches: touched, first } =
            self.detector.examine(&view, t1 >= self.horizon).map_err(as_step)?;
        let end = first.as_ref().map_or(1.0, |(theta, _)| theta.min(1.0));
        if first.is_some() && self.is_nearly_singular(dense, end) {
            return Err(StepError::Unresolved { t: at(end) });
        }
        let work = self.known_work(&view, dense, end);
        let is_late = at(end) - self.t > LATE * self.context.scales.time;
        let landing = first.as_ref().filter(|_| is_late);
        let unseen = landing
            .map_or(ContactSet::EMPTY, |(_, guards)| self.detector.unseen_landings(&view, end, guards));
        if let Some(theta) = self.detector.undecided().filter(|theta| *theta <= end) {
            self.note_once(at(theta), LoggedDecision::ConditionUndecided);
        }
        for contact in unseen.iter() {
            let (contact, since) = (self.context.layout().contacts[contact].label, self.t);
            self.note_once(at(end), LoggedDecision::LandingUnresolved { contact, since });
        }
        recording.phase.t1 = if end < 1.0 { at(end) } else { t1 };
        let known = touches.len();
        touches.extend(touched.into_iter().map(|(theta, guard)| {
            let (t, point) = (at(theta), recording.phase.interpolate(at(theta)));
            let (energy, reactions) = (point.energy(), point.reactions().to_vec());
            let undecided = self.detector.is_undecided(guard, &reactions, &self.context.gaps(point.state()));
            let state = self.context.layout().public_state(point.state()).to_vec();
            Touch { t, guard, undecided, state, energy, reactions }
        }));
        for touch in &touches[known..] {
            if !matches!(touch.guard, Guard::Foot { .. } | Guard::Condition(_)) {
                self.observer.event(touch.t);
            }
        }
        let powers = self.detector.friction_powers().filter(|_| end == 1.0);
        if let Some(work) = work {
            self.progress.work.add_known(work);
        } else if !powers.is_some_and(|powers| self.progress.work.add_sampled(self.context, &powers, h)) {
            self.add_work(recording);
        }
        self.observer.step(&LastStep { context: self.context, recorded: &recording.phase });
        Ok(first.map(|(_, guards)| guards))
    }

    /// The work up to a place of a step, where it takes no quadrature of its own.
    fn known_work(&self, view: &StepView<'_>, dense: &DenseOutput, end: f64) -> Option<f64> {
        if self.context.is_worked_on() {
            return work_of(self.context, &*self.phase, (dense, end), self.tolerance);
        }
        self.detector.friction_work(view, end)
    }
}
