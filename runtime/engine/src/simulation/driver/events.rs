//! What a run does at each event, and what it records.

use nalgebra::DVector;

use super::friction::LocatedSlips;
use super::plan::split;
use super::{Driver, Next};
use crate::event::detection::Guard;
use crate::event::{Event, EventKind, Note, PreImpact, reactions, supports};
use crate::expression::Condition;
use crate::model::{ContactSet, Energy, Form, Slip};
use crate::simulation::RunCause;
use crate::simulation::awaited::Role;
use crate::simulation::phase_run::{LastStep, Touch};
use crate::trajectory::{LogEntry, LoggedDecision, RecordedPhase, Trajectory};

impl Driver<'_> {
    pub(super) fn reach_horizon(&mut self) -> Result<Next, RunCause> {
        self.record_settled(ContactSet::EMPTY);
        let stop = self.setup.stops().any(|at| at == self.t);
        self.do_due()?;
        if stop {
            let met = |c: &&Condition| c.time(&self.setup.context.model.parameters) == Some(self.t);
            let note = self.setup.conditions.iter().find(met).cloned().map(Note::Condition);
            self.record(EventKind::Stop, ContactSet::EMPTY, note);
        } else if self.has_seen_enough() {
            // The last of the events that were waited for ends the run.
        } else if self.t >= self.setup.time_limit() {
            self.record(EventKind::End, ContactSet::EMPTY, None);
        } else {
            return Ok(Next::Continue);
        }
        Ok(Next::Finished)
    }

    /// Reactions first; then what ends the run, at the state before any impact; then impacts and what is planned.
    pub(super) fn handle(&mut self, guards: &[Guard]) -> Result<Next, RunCause> {
        let pick =
            |kind: fn(&Guard) -> Option<usize>| -> ContactSet { guards.iter().filter_map(kind).collect() };
        let unloaded = pick(|g| if let Guard::Reaction(i) | Guard::Side(i, _) = g { Some(*i) } else { None });
        let closing = pick(|g| g.gap());
        let closing = closing.difference(self.beyond_end());
        let sliding = pick(|g| if let Guard::Foot { contact, .. } = g { Some(*contact) } else { None });
        let met = guards.iter().filter_map(|g| if let Guard::Condition(k) = g { Some(*k) } else { None });
        let (mut stops, mut planned, mut switched) = (Vec::new(), Vec::new(), Vec::new());
        for k in met {
            match self.awaited.role(k) {
                Role::Stop => stops.push(k),
                Role::Planned(entry) => planned.push(entry),
                Role::Switch { switch, arms } => switched.push((switch, arms)),
                Role::Domain(_) => {}
            }
        }
        let slips = self.located_slips(guards);
        let unloaded = unloaded.difference(self.still_rubbing(&slips));
        self.record_settled(unloaded.union(sliding));
        if !sliding.is_empty() {
            self.slide_off(sliding, unloaded)?;
        } else if !unloaded.is_empty() || !slips.is_empty() {
            self.open(unloaded, &slips)?;
        } else if guards.contains(&Guard::Grip) {
            self.keep_grip();
        }
        if stops.is_empty() && !switched.is_empty() {
            self.switch(&switched)?;
        }
        let closing = closing.difference(self.removed);
        let barred = self.terminal(closing);
        if !barred.is_empty() {
            self.record(EventKind::Close, barred, None);
        }
        if let Some(&k) = stops.first() {
            let note = Note::Condition(self.awaited.conditions[k].clone());
            self.record(EventKind::Stop, ContactSet::EMPTY, Some(note));
        }
        if !stops.is_empty() || !barred.is_empty() {
            return Ok(Next::Finished);
        }
        if !closing.is_empty() {
            self.resolve_impact(closing)?;
        }
        self.execute(&planned)?;
        Ok(Next::Continue)
    }

    /// Of the contacts that close those that end the run.
    pub(super) fn terminal(&self, closing: ContactSet) -> ContactSet {
        let stops = |i: &usize| self.setup.stops_at_impacts || self.layout().contacts[*i].stop;
        if closing.iter().any(|i| stops(&i)) { closing } else { ContactSet::EMPTY }
    }

    /// Opens the contacts whose feet have reached the ends of their bars, held ones too.
    fn slide_off(&mut self, sliding: ContactSet, unloaded: ContactSet) -> Result<(), RunCause> {
        let before = self.closed;
        self.touching = self.touching.difference(sliding);
        self.held = self.held.difference(sliding);
        self.decide(unloaded.difference(sliding))?;
        self.record(EventKind::SlideOff, sliding, None);
        self.record_opened(before.difference(self.closed.union(sliding)));
        self.record_slips(before);
        Ok(())
    }

    fn open(&mut self, unloaded: ContactSet, slips: &LocatedSlips) -> Result<(), RunCause> {
        self.refuse_lost_inertia()?;
        let (before, blurred, recorded) = (self.closed, self.is_blurred(), self.trajectory.events.len());
        self.decide_slips(unloaded, slips)?;
        let opened = before.difference(self.closed);
        let located = unloaded.union(slips.contacts());
        if before != self.closed {
            self.record_changes(before);
            if blurred {
                self.tell_undecided(recorded);
            }
            self.lifted = if slips.is_empty() { opened } else { opened.intersection(unloaded) };
        } else if !unloaded.is_empty() && !unloaded.difference(self.bearing).is_empty() {
            self.log(LoggedDecision::BearingChanged);
        } else {
            // The guard has crossed, and what follows says that it has not.
            self.record(EventKind::Touch, located, Some(Note::Undecided));
            self.kept = located;
        }
        Ok(())
    }

    /// Events from the `first` on are undecided, unless something else is said of them.
    pub(super) fn tell_undecided(&mut self, first: usize) {
        let events = self.trajectory.events.iter_mut().skip(first);
        events.for_each(|event| _ = event.note.get_or_insert(Note::Undecided));
    }

    /// Contacts that share their load are at their limits, and none of them can slip, as at a dead centre.
    fn keep_grip(&mut self) {
        let sticks =
            |i: &usize| self.layout().contacts[*i].friction.is_some() && self.closed.slip(*i) == Slip::Stick;
        let sticking: ContactSet = self.closed.iter().filter(sticks).collect();
        self.record(EventKind::Touch, sticking, Some(Note::LimitTouches));
        self.kept = sticking;
    }

    /// What of the contacts that were closed before has come open, or slips otherwise.
    pub(super) fn record_changes(&mut self, before: ContactSet) {
        if before == self.closed {
            return;
        }
        self.record_opened(before.difference(self.closed));
        self.record_slips(before);
    }

    /// Contacts that only depended on those that bear where the phase began, and have parted since: they opened there.
    pub(super) fn record_parted(&mut self, recorded: &mut RecordedPhase, guards: &[Guard]) {
        let parted = guards.iter().filter_map(|g| if let Guard::Parting(i) = g { Some(*i) } else { None });
        let parted: ContactSet = parted.collect();
        if parted.is_empty() {
            return;
        }
        self.closed = self.closed.difference(parted);
        self.touching = self.touching.difference(parted);
        self.reactions = self.reactions_at(&self.state, self.bearing).0;
        self.record_opened(parted);
        recorded.open(parted);
    }

    /// Supports open, threads go slack.
    pub(super) fn record_opened(&mut self, opened: ContactSet) {
        let (threads, supports) = split(self.layout(), opened);
        self.record_some(EventKind::Open, supports);
        self.record_some(EventKind::Slack, threads);
    }

    pub(super) fn record_some(&mut self, kind: EventKind, set: ContactSet) {
        if !set.is_empty() {
            self.record(kind, set, None);
        }
    }

    /// An event with the impulses of the contacts in `shown`.
    pub(super) fn record_impact(
        &mut self,
        kind: EventKind,
        set: ContactSet,
        shown: ContactSet,
        (before, impulses): (Option<PreImpact>, &DVector<f64>),
        note: Option<Note>,
    ) {
        self.record(kind, set, note);
        if let Some(before) = &before {
            self.show_jump(before);
        }
        let layout = self.layout();
        if let Some(event) = self.trajectory.events.last_mut() {
            event.impulses = reactions(layout, impulses.as_slice());
            event.impulses.retain(|impulse| shown.contains(impulse.contact));
            event.before = before;
        }
    }

    pub(super) fn record(&mut self, kind: EventKind, set: ContactSet, note: Option<Note>) {
        self.observer.event(self.t);
        let event = self.event(kind, set, note);
        self.trajectory.events.push(event);
    }

    /// What an impact finds.
    pub(super) fn pre_impact(&self) -> PreImpact {
        let bears = |i: &usize| self.reactions[*i] != 0.0;
        let bearing = self.closed.iter().filter(bears).collect();
        PreImpact { state: self.public_state().to_vec(), energy: self.energy_now(), bearing }
    }

    fn energy_now(&self) -> Energy<f64> {
        self.setup.context.system().energy(&self.state)
    }

    /// Shows the observer the end of the motion before the velocities jump.
    fn show_jump(&mut self, found: &PreImpact) {
        let context = &self.setup.context;
        let Trajectory { phases, last_phase, before_start, .. } = &mut self.trajectory;
        let before = match phases.last().or(last_phase.as_ref()) {
            Some(phase) => Some(phase).filter(|phase| phase.t0 < self.t),
            None => Some(&*before_start.get_or_insert_with(|| {
                let bearing = found.bearing.union(context.layout().guides());
                let phase = context.phase(bearing, Form::Projected);
                let mut state = self.state.clone();
                state[..found.state.len()].copy_from_slice(&found.state);
                RecordedPhase::still((phase, bearing), self.t, &state)
            })),
        };
        if let Some(recorded) = before {
            self.observer.jump(&LastStep { context, recorded });
        }
    }

    /// An event now, without impulses.
    pub(super) fn event(&self, kind: EventKind, set: ContactSet, note: Option<Note>) -> Event {
        Event {
            t: self.t,
            kind,
            supports: supports(self.layout(), set),
            state: self.public_state().to_vec(),
            energy: self.energy_now(),
            before: None,
            reactions: reactions(self.layout(), &self.reactions),
            impulses: Vec::new(),
            note,
            coordinates: self.layout().coordinates,
            dependent: self.setup.context.dependent(&self.state),
            length: self.setup.context.scales.length,
        }
    }

    pub(super) fn record_touch(&mut self, touch: Touch) {
        let Touch { t, guard, undecided, state, energy, reactions: bearing } = touch;
        let (contact, note) = match guard {
            Guard::Reaction(i) | Guard::Side(i, _) => (i, undecided.then_some(Note::Undecided)),
            Guard::Gap(i) => (i, Some(if undecided { Note::GapUndecided } else { Note::GapTouches })),
            Guard::Limit(rub) => (rub.contact, Some(Note::LimitTouches)),
            Guard::Slip(rub) => (rub.contact, Some(Note::SlipTouches)),
            Guard::Parting(_) | Guard::Foot { .. } | Guard::Grip | Guard::Condition(_) => return,
        };
        let (kind, set) = (EventKind::Touch, ContactSet::EMPTY.with(contact));
        let event = Event {
            t,
            state,
            energy,
            reactions: reactions(self.layout(), &bearing),
            ..self.event(kind, set, note)
        };
        self.trajectory.events.push(event);
    }

    /// Shows the observer what has happened since it was last shown, and keeps what it has not taken, what the run waits for, and
    /// what ends it.
    pub(super) fn show_events(&mut self, ends: bool) {
        let events = &mut self.trajectory.events;
        while let Some(event) = events.get(self.shown) {
            let is_awaited = || self.setup.event_filters.iter().any(|awaited| awaited.is(event));
            let is_kept = ends || self.shown == 0 || is_awaited();
            if self.observer.happened(event) && !is_kept {
                events.remove(self.shown);
                self.taken += 1;
            } else {
                self.shown += 1;
            }
        }
    }

    pub(super) fn log(&mut self, decision: LoggedDecision) {
        self.trajectory.log.push(LogEntry { t: self.t, decision });
    }
}
