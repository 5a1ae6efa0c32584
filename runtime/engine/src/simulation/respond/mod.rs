//! What events do: contacts open, slip, are struck, come and go; what ends a run.

mod begin;
mod collide;
mod drives;
mod jumps;
mod located;
mod paradox;
mod plan;
mod switch;
mod zeno;

#[cfg(test)]
mod tests;

use crate::contact::{ContactError, are_determined, refuse_singular};
use crate::event::detection::Guard;
use crate::event::{Event, EventKind, Note, reactions};
use crate::expression::Condition;
use crate::integrate::StepError;
use crate::model::{ContactSet, Form, Slip};
use crate::simulation::RunCause;
use crate::simulation::decide::{DecisionInput, LocatedSlips, Refusal, Unsolved};
use crate::simulation::phase_run::Touch;
use crate::simulation::snapshot::{PhaseStart, Snapshot};
use crate::trajectory::LoggedDecision;
use located::Located;

/// Whether the run goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::simulation) enum Next {
    Continue,
    Finished,
}

impl Snapshot<'_> {
    /// Goes on as is decided; a slip that no reaction obeys the law of friction in is ended by an
    /// impact without collision.
    pub(in crate::simulation) fn go_on(&mut self, question: DecisionInput) -> Result<(), RunCause> {
        match self.decide(&question) {
            Ok(decision) => {
                self.adopt(decision);
                Ok(())
            }
            Err(Refusal::Contacts(unsolved)) => {
                let Unsolved { touching, source } = *unsolved;
                self.unjam(&DecisionInput { touching, ..question }, source)
            }
            Err(Refusal::Run(cause)) => Err(cause),
        }
    }

    /// What comes to its end at this time, and what is due. Whether the run is to stop now.
    pub(in crate::simulation) fn reach_time(&mut self) -> Result<Next, RunCause> {
        self.record_settled(ContactSet::EMPTY);
        self.do_due()?;
        if self.setup.stops().all(|at| at != self.t) {
            return Ok(Next::Continue);
        }
        let met = |c: &&Condition| c.time(&self.setup.context.model.parameters) == Some(self.t);
        let note = self.setup.ends.conditions.iter().find(met).cloned().map(Note::Condition);
        self.record(EventKind::Stop, ContactSet::EMPTY, note);
        Ok(Next::Finished)
    }

    /// Reactions first; then what ends the run, at the state before any impact; then impacts and
    /// what is planned.
    pub(in crate::simulation) fn handle(
        &mut self,
        guards: &[Guard],
        start: &PhaseStart,
    ) -> Result<Next, RunCause> {
        let Located { unloaded, closing, sliding, slips, shares, stops, planned, switched } =
            self.locate(guards);
        let unloaded = unloaded.difference(self.at_limit_with_load(&slips));
        self.record_settled(unloaded.union(sliding));
        if !sliding.is_empty() {
            self.slide_off(sliding, unloaded)?;
        } else if !unloaded.is_empty() || !slips.is_empty() {
            self.open(unloaded, slips, start)?;
        } else if shares {
            self.keep_grip();
        }
        if stops.is_empty() && !switched.is_empty() {
            self.switch(&switched)?;
        }
        let closing = closing.difference(self.contacts.absent());
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
    pub(in crate::simulation) fn terminal(&self, closing: ContactSet) -> ContactSet {
        let stops = |i: &usize| self.setup.ends.at_impacts || self.layout().contacts[*i].stop;
        if closing.iter().any(|i| stops(&i)) { closing } else { ContactSet::EMPTY }
    }

    /// Opens the contacts whose feet have reached the ends of their bars, held ones too.
    fn slide_off(&mut self, sliding: ContactSet, unloaded: ContactSet) -> Result<(), RunCause> {
        let before = self.closed();
        self.contacts.slide_off(sliding);
        self.go_on(DecisionInput { unloaded: unloaded.difference(sliding), ..self.question() })?;
        self.record(EventKind::SlideOff, sliding, None);
        self.record_opened(before.difference(self.closed().union(sliding)));
        self.record_slips(before);
        Ok(())
    }

    fn open(
        &mut self,
        unloaded: ContactSet,
        located: LocatedSlips,
        start: &PhaseStart,
    ) -> Result<(), RunCause> {
        self.refuse_lost_inertia(start)?;
        let (before, blurred, recorded) = (self.closed(), self.is_blurred(), self.transition.events.len());
        let (slipping, slips) = (!located.is_empty(), located.contacts());
        self.go_on(DecisionInput { unloaded, located, ..self.question() })?;
        let opened = before.difference(self.closed());
        if before != self.closed() {
            self.record_changes(before);
            if blurred {
                self.mark_undecided(recorded);
            }
            self.onset.opened_at_zero_reaction =
                if slipping { opened.intersection(unloaded) } else { opened };
        } else if !unloaded.is_empty() && !unloaded.difference(self.active_basis()).is_empty() {
            self.log(LoggedDecision::BearingChanged);
        } else {
            // The guard has crossed, and what follows says that it has not.
            let located = unloaded.union(slips);
            self.record(EventKind::Touch, located, Some(Note::Undecided));
            self.onset.suppressed = located;
        }
        Ok(())
    }

    /// Where a motion comes to a position at which it loses inertia, rates grow beyond all bounds
    /// and reactions lose their digits: a zero of one is no event there.
    fn refuse_lost_inertia(&self, start: &PhaseStart) -> Result<(), RunCause> {
        let model = &self.setup.context.model;
        let had_inertia = || refuse_singular(model, &start.state, self.closed()).is_ok();
        if are_determined(&*model.system, &self.state) || !had_inertia() {
            return Ok(());
        }
        self.refuse_singular()
    }

    /// The cause of a failed step may be accelerations that are nearly undetermined; then that is
    /// the error.
    pub(in crate::simulation) fn refuse_singular(&self) -> Result<(), RunCause> {
        let refused = refuse_singular(&self.setup.context.model, &self.state, self.closed());
        refused.map_err(|source| self.contact_error(source))
    }

    /// Motion that is not a number where hinges slide has come to where their law leaves none.
    pub(in crate::simulation) fn refuse_hinges(&self, error: &StepError) -> Result<(), RunCause> {
        let closed = self.closed();
        let sliding = self.layout().sliding(&closed).map(|(_, friction)| friction.contact);
        let hinges =
            sliding.map(|contact| &self.layout().contacts[contact]).filter(|contact| contact.is_hinge());
        let hinges: Vec<String> = hinges.map(|contact| contact.label.to_owned()).collect();
        match (matches!(error, StepError::NotFinite { .. }), hinges.is_empty()) {
            (true, false) => Err(self.contact_error(ContactError::Hinges { hinges })),
            _ => Ok(()),
        }
    }

    /// Contacts that share their load are at their limits, and none of them can slip, as at a dead
    /// centre.
    fn keep_grip(&mut self) {
        let sticks = |i: &usize| {
            self.layout().contacts[*i].friction.is_some() && self.closed().slip(*i) == Slip::Stick
        };
        let sticking: ContactSet = self.closed().iter().filter(sticks).collect();
        self.record(EventKind::Touch, sticking, Some(Note::LimitTouches));
        self.onset.suppressed = sticking;
    }

    /// Contacts that only depended on those that bear where the phase began, and have parted since:
    /// they opened there.
    pub(in crate::simulation) fn part(&mut self, parted: ContactSet) {
        self.contacts.open(parted);
        self.reactions = self.reactions_at(&self.state, self.active_basis()).0;
        self.record_opened(parted);
    }

    /// Integrates the phase in its projected form from here on.
    pub(in crate::simulation) fn leave_chart(&mut self) {
        self.phase = self.setup.context.phase(self.active_basis(), Form::Multipliers);
        self.log(LoggedDecision::SmallPivot);
    }

    /// Others bear than was decided.
    pub(in crate::simulation) fn bear(&mut self, bearing: ContactSet) -> Result<(), RunCause> {
        let entry = self.enter(bearing, false)?;
        self.reactions = self.reactions_at(&self.state, bearing).0;
        self.adopt_entry(entry);
        Ok(())
    }

    /// The event of a guard that has touched zero on the way.
    pub(in crate::simulation) fn touch_event(&self, touch: Touch) -> Option<Event> {
        let Touch { t, guard, undecided, state, energy, reactions: bearing } = touch;
        let (contact, note) = match guard {
            Guard::Reaction(i) | Guard::Side(i, _) => (i, undecided.then_some(Note::Undecided)),
            Guard::Gap(i) => (i, Some(if undecided { Note::GapUndecided } else { Note::GapTouches })),
            Guard::Limit(rub) => (rub.contact, Some(Note::LimitTouches)),
            Guard::Slip(rub) => (rub.contact, Some(Note::SlipTouches)),
            Guard::RedundantGap(_) | Guard::Foot { .. } | Guard::SharedFriction | Guard::Condition(_) => {
                return None;
            }
        };
        let event = self.event(EventKind::Touch, ContactSet::EMPTY.with(contact), note);
        Some(Event { t, state, energy, reactions: reactions(self.layout(), &bearing), ..event })
    }
}
