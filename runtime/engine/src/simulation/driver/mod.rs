//! The event loop: decide the closed contacts, integrate their phase to the first event, respond to
//! it, decide again.

mod dependent;
mod phase;

use super::awaited::Awaited;
use super::respond::Next;
use super::snapshot::{PhaseStart, Snapshot, TransitionRecord};
use super::{Allowance, Exhausted, RunCause, RunError, Simulation};
use crate::assembly::{ConsistentStart, StartError};
use crate::contact::{ContactError, labels};
use crate::event::detection::{Broken, Guard, KnownAffineGuards};
use crate::event::{EventKind, PreImpact};
use crate::integrate::{Counts, StepError};
use crate::model::{ContactSet, Form};
use crate::simulation::phase_run::{LastStep, PhaseOutcome, Termination};
use crate::trajectory::observe::Observer;
use crate::trajectory::{LogEntry, LoggedDecision, RecordedPhase, Trajectory};

/// A run in progress.
pub(crate) struct Driver<'a> {
    setup: &'a Simulation,
    observer: &'a mut dyn Observer,
    now: Snapshot<'a>,
    trajectory: Trajectory,
    affine: KnownAffineGuards,
    allowance: Allowance,
    /// How many events of the trajectory the observer has been shown, and how many it has taken.
    shown: usize,
    taken: usize,
    /// The state in which the phase before has ended, as it was recorded.
    ended: Option<Vec<f64>>,
    /// How many phases have start since time last advanced.
    stalled: usize,
}

impl<'a> Driver<'a> {
    pub(crate) fn new(
        setup: &'a Simulation,
        awaited: &'a Awaited,
        start: ConsistentStart,
        observer: &'a mut dyn Observer,
    ) -> Self {
        let last = setup.layout().public_state(&start.state).to_vec();
        Self {
            setup,
            observer,
            trajectory: Trajectory::empty(setup.context.clone(), setup.tolerance, (setup.begin, last)),
            now: Snapshot::new(setup, awaited, start),
            affine: KnownAffineGuards::default(),
            allowance: Allowance::new(setup.budget),
            shown: 0,
            taken: 0,
            ended: None,
            stalled: 0,
        }
    }

    pub(crate) fn run(mut self) -> Result<Trajectory, RunError> {
        let played = self.play();
        self.show_events(true);
        self.trajectory.conditions.clone_from(&self.now.awaited.conditions);
        match played {
            Ok(()) => {
                self.keep_end();
                Ok(self.trajectory)
            }
            Err(cause) => Err(RunError::new(cause, self.trajectory)),
        }
    }

    fn play(&mut self) -> Result<(), RunCause> {
        self.check()?;
        let mut next = self.respond(Snapshot::begin)?;
        while let Next::Continue = next {
            self.show_events(false);
            self.respond(Snapshot::settle_unseen)?;
            self.bear_what_sinks()?;
            if let Some(ended) = &self.ended {
                self.now.refuse_seam(ended)?;
            }
            let start = self.now.phase_start();
            let outcome = self.integrate(false);
            next = self.follow(outcome, &start)?;
        }
        Ok(())
    }

    /// Refuses tolerances, limits and held contacts with which no run can begin.
    fn check(&self) -> Result<(), RunCause> {
        let Simulation { tolerance, begin, held, .. } = *self.setup;
        let limit = self.setup.time_limit();
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(RunCause::Tolerance(tolerance));
        }
        if !(limit > begin && limit.is_finite()) {
            return Err(RunCause::Limit(limit));
        }
        let Some(i) = held.difference(self.now.closed()).iter().next() else { return Ok(()) };
        let support = self.setup.layout().contacts[i].label.to_owned();
        Err(StartError::HeldOpen { support, gap: self.now.gaps()[i] }.into())
    }

    /// Changes the snapshot and takes note of what it tells, also where the run cannot go on.
    fn respond<T>(
        &mut self,
        response: impl FnOnce(&mut Snapshot<'a>) -> Result<T, RunCause>,
    ) -> Result<T, RunCause> {
        let answer = response(&mut self.now);
        self.take_transition();
        answer
    }

    fn take_transition(&mut self) {
        let TransitionRecord { events, log, impulses } = core::mem::take(&mut self.now.transition);
        for event in events {
            self.observer.event(event.t);
            if let Some(found) = &event.before {
                self.show_jump(found);
            }
            self.trajectory.events.push(event);
        }
        for entry in log {
            self.log_once(entry);
        }
        self.trajectory.impulses.extend(impulses);
        self.keep_last();
    }

    /// Logs a decision; that the order of impacts matters only once for the same contacts.
    fn log_once(&mut self, entry: LogEntry) {
        let is_same = |known: &LogEntry| match (&known.decision, &entry.decision) {
            (LoggedDecision::ImpactOrder(known), LoggedDecision::ImpactOrder(order)) => known.is_same(order),
            _ => false,
        };
        if !self.trajectory.log.iter().any(is_same) {
            self.trajectory.log.push(entry);
        }
    }

    fn keep_last(&mut self) {
        let last = &mut self.trajectory.last;
        last.clear();
        last.extend_from_slice(self.now.public_state());
    }

    /// Follows a phase with what its end asks for.
    fn follow(&mut self, outcome: PhaseOutcome, start: &PhaseStart) -> Result<Next, RunCause> {
        let logged = self.trajectory.log.len();
        let (counts, work, memory) = (outcome.counts, outcome.work, outcome.memory);
        let end = self.take(outcome)?;
        if self.stalled > 4 + 2 * self.setup.layout().contacts.len() {
            self.now.refuse_singular()?;
            return Err(self.stalled_by(&end));
        }
        self.spend(counts, memory)?;
        let now = &self.now;
        if let Termination::Event(guards) = &end {
            now.refuse_left(guards)?;
        }
        let breaks = matches!(end, Termination::Failed(_) | Termination::Drive(_) | Termination::Seam(_));
        if !breaks && !matches!(end, Termination::Singular(_) | Termination::Loop(_)) {
            now.refuse_drift(start, counts, &work, &self.trajectory.log[logged..])?;
        }
        match end {
            Termination::Exhausted(of) => Err(now.exhausted(of)),
            Termination::Failed(error) => Err(self.failed_by(error)),
            Termination::Seam(jump) => Err(RunCause::Invariant(jump)),
            Termination::Cancelled => Err(RunCause::Cancelled { t: now.t }),
            Termination::Loop(joints) => {
                now.refuse_vanishing()?;
                Err(RunCause::Loop { joints, t: now.t })
            }
            Termination::Singular(source) => Err(now.contact_error(source)),
            Termination::Drive(Broken { t, expression, what }) => {
                Err(RunCause::Drive { t, expression, what })
            }
            Termination::Pivot => {
                self.respond(|now| {
                    now.leave_chart();
                    Ok(())
                })?;
                Ok(Next::Continue)
            }
            Termination::Paradox | Termination::Horizon | Termination::Event(_) => self.pass(&end, start),
        }
    }

    /// Takes over what a phase has brought, and says how it ended.
    fn take(&mut self, outcome: PhaseOutcome) -> Result<Termination, RunCause> {
        let PhaseOutcome {
            mut recorded, touches, log, end, t, state, ended, reactions, counts, below, ..
        } = outcome;
        if let (Some(recorded), Termination::Event(guards)) = (&mut recorded, &end) {
            let parted: ContactSet = guards
                .iter()
                .filter_map(|guard| if let Guard::RedundantGap(i) = guard { Some(*i) } else { None })
                .collect();
            if !parted.is_empty() {
                let parted = parted.union(self.now.parted_dependent(&state));
                self.respond(|now| {
                    now.part(parted);
                    Ok(())
                })?;
                recorded.open(parted);
            }
        }
        let onset = core::mem::take(&mut self.now.onset);
        self.stalled += 1;
        if t > self.now.t {
            (self.stalled, self.now.bounces.wedged) = (0, 0);
        }
        (self.now.t, self.now.state, self.now.reactions, self.ended) = (t, state, reactions, Some(ended));
        self.now.contacts.set_below(below);
        self.trajectory.end = t;
        self.trajectory.statistics.add(counts);
        self.trajectory.log.extend(log);
        self.keep_last();
        let touched = touches.into_iter().filter_map(|touch| self.now.touch_event(touch));
        self.trajectory.events.extend(touched);
        if let Some(mut recorded) = recorded {
            let contacts = &self.now.contacts;
            recorded.is_struck = onset.is_struck;
            recorded.held = contacts.held();
            recorded.removed = contacts.absent().union(contacts.waiting());
            let guards = if let Termination::Event(guards) = &end { guards.clone() } else { Vec::new() };
            self.keep(recorded, guards);
        } else {
            self.now.onset.is_struck = onset.is_struck;
        }
        Ok(end)
    }

    /// What happens at the end of a phase, and what that makes true at once.
    fn pass(&mut self, end: &Termination, start: &PhaseStart) -> Result<Next, RunCause> {
        let before = self.now.before_event();
        let (next, roots) = match end {
            Termination::Event(guards) => (self.respond(|now| now.handle(guards, start))?, &guards[..]),
            Termination::Paradox => {
                self.respond(Snapshot::cross_border)?;
                (Next::Continue, &[][..])
            }
            _ => (self.reach_horizon()?, &[][..]),
        };
        match next {
            Next::Continue => self.respond(|now| now.follow_jumps(before, roots)),
            Next::Finished => Ok(Next::Finished),
        }
    }

    fn reach_horizon(&mut self) -> Result<Next, RunCause> {
        let next = self.respond(Snapshot::reach_time)?;
        if next == Next::Finished || self.has_seen_enough() {
            return Ok(Next::Finished);
        }
        if self.now.t < self.setup.time_limit() {
            return Ok(Next::Continue);
        }
        self.respond(|now| {
            now.record(EventKind::End, ContactSet::EMPTY, None);
            let setup = now.setup;
            for condition in &setup.ends.conditions {
                now.log(LoggedDecision::ConditionNotMet(condition.clone()));
            }
            Ok(())
        })?;
        Ok(Next::Finished)
    }

    /// Whether all events have happened that the run was to wait for.
    fn has_seen_enough(&self) -> bool {
        let (awaited, events) = (&self.setup.ends.events, &self.trajectory.events);
        !awaited.is_empty() && awaited.iter().all(|awaited| events.iter().any(|event| awaited.is(event)))
    }

    /// Takes what a phase needed from the budget.
    fn spend(&mut self, counts: Counts, memory: usize) -> Result<(), RunCause> {
        self.allowance.spend(counts.accepted + counts.rejected, memory);
        let most = self.setup.budget.events;
        if self.taken + self.trajectory.events.len() > most {
            return Err(self.now.exhausted(Exhausted::Events(most)));
        }
        self.allowance.exceeded_by(0, 0).map_or(Ok(()), |of| Err(self.now.exhausted(of)))
    }

    /// What a step has failed by: a bound of the equations, accelerations that are nearly
    /// undetermined, or hinges that have come to where their law leaves no motion; else the step's
    /// own error.
    fn failed_by(&self, error: StepError) -> RunCause {
        let now = &self.now;
        let checked = now.refuse_vanishing().and_then(|()| now.refuse_singular());
        let cause = checked.and_then(|()| now.refuse_hinges(&error));
        cause.err().unwrap_or_else(|| error.into())
    }

    /// Why events follow one another without time: a hinge at its limit that has no motion beyond
    /// it, else that is not decided.
    fn stalled_by(&self, end: &Termination) -> RunCause {
        let guards = if let Termination::Event(guards) = end { &guards[..] } else { &[] };
        let (now, layout) = (&self.now, self.setup.layout());
        let at_zero: ContactSet = match guards.contains(&Guard::SharedFriction) {
            true => now.closed(),
            false => guards.iter().filter_map(Guard::contact).collect(),
        };
        let limited =
            guards.iter().filter_map(|g| if let Guard::Limit(rub) = g { Some(rub.contact) } else { None });
        let hinges: ContactSet = limited.filter(|&i| layout.contacts[i].is_hinge()).collect();
        match hinges.is_empty() {
            true => RunCause::Stalled { t: now.t, contacts: labels(layout, at_zero) },
            false => now.contact_error(ContactError::Hinges { hinges: labels(layout, hinges) }),
        }
    }

    /// What ends before it has moved is a phase of no duration.
    fn keep_end(&mut self) {
        if self.trajectory.phases.is_empty() && self.trajectory.last_phase.is_none() {
            let now = &self.now;
            let phase = self.setup.context.phase(now.active_basis(), Form::Multipliers);
            self.keep(RecordedPhase::still((phase, now.closed()), now.t, &now.state), Vec::new());
        }
    }

    /// Keeps a phase, or its end in place of that of the one before.
    fn keep(&mut self, phase: RecordedPhase, guards: Vec<Guard>) {
        if self.observer.records() {
            self.trajectory.phases.push(phase);
            self.trajectory.ends.push(guards);
        } else {
            self.trajectory.last_phase = Some(phase);
        }
    }

    /// Shows the observer the end of the motion before the velocities jump.
    fn show_jump(&mut self, found: &PreImpact) {
        let (context, now) = (&self.setup.context, &self.now);
        let Trajectory { phases, last_phase, before_start, .. } = &mut self.trajectory;
        let before = match phases.last().or(last_phase.as_ref()) {
            Some(phase) => Some(phase).filter(|phase| phase.t0 < now.t),
            None => Some(&*before_start.get_or_insert_with(|| {
                let bearing = found.active_basis.union(context.layout().guides());
                let phase = context.phase(bearing, Form::Multipliers);
                let mut state = now.state.clone();
                state[..found.state.len()].copy_from_slice(&found.state);
                RecordedPhase::still((phase, bearing), now.t, &state)
            })),
        };
        if let Some(recorded) = before {
            self.observer.jump(&LastStep { context, recorded });
        }
    }

    /// Shows the observer what has happened since it was last shown, and keeps what it has not
    /// taken, what the run waits for, and what ends it.
    fn show_events(&mut self, ends: bool) {
        let events = &mut self.trajectory.events;
        while let Some(event) = events.get(self.shown) {
            let is_awaited = || self.setup.ends.events.iter().any(|awaited| awaited.is(event));
            let is_kept = ends || self.shown == 0 || is_awaited();
            if self.observer.happened(event) && !is_kept {
                events.remove(self.shown);
                self.taken += 1;
            } else {
                self.shown += 1;
            }
        }
    }
}
