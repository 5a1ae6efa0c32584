//! The start of a run.

use super::Next;
use super::jumps::Before;
use crate::assembly::{StartError, deepest, touches};
use crate::context::CLOSED;
use crate::event::{Event, EventKind, Guard, Note, reactions};
use crate::expression::Condition;
use crate::integration::equilibrium::is_equilibrium;
use crate::model::ContactSet;
use crate::numerics::zero::SOLVED;
use crate::simulation::RunCause;
use crate::simulation::awaited::Role;
use crate::simulation::decide::DecisionInput;
use crate::simulation::schedule::{Action, Scheduled, Trigger};
use crate::simulation::snapshot::Snapshot;
use crate::trajectory::{LogEntry, LoggedDecision};

impl Snapshot<'_> {
    /// The phase of the start, after the impact of what its rates drive into a support, or without
    /// collision where they obey no law of friction.
    pub(in crate::simulation) fn begin(&mut self) -> Result<Next, RunCause> {
        self.refuse_vanishing()?;
        if let Next::Finished = self.start()? {
            return Ok(Next::Finished);
        }
        self.log_met_conditions();
        self.do_due()?;
        self.break_at_start()
    }

    /// Breaks what is beyond its strength at once, and drives that do not hold: they have broken
    /// before.
    fn break_at_start(&mut self) -> Result<Next, RunCause> {
        let (setup, point, closed) = (self.setup, self.point(), self.closed());
        let is_lost = |i: &usize| {
            let contact = &self.layout().contacts[*i];
            contact.kind.is_drive() && contact.armed.is_none() && !closed.contains(*i)
        };
        let breaks = |planned: &Scheduled| {
            let Scheduled { action: Action::Remove(contacts), when: Trigger::If(condition) } = planned else {
                return false;
            };
            condition.holds(&setup.context, &point) || contacts.iter().any(|i| is_lost(&i))
        };
        let broken: Vec<usize> = (0..setup.rules.breaks.len()).filter(|&k| breaks(&setup.plan[k])).collect();
        if broken.is_empty() {
            return Ok(Next::Continue);
        }
        let before = self.before_event();
        self.execute(&broken)?;
        self.follow_jumps(before, &[])
    }

    fn start(&mut self) -> Result<Next, RunCause> {
        let (before, striking) = (self.before_event(), self.striking());
        let start = self.event(EventKind::Start, ContactSet::EMPTY, None);
        if striking.is_empty() {
            self.decide_at_start()?;
            self.refuse_equilibrium()?;
            if self.transition.events.is_empty() {
                self.record(EventKind::Start, ContactSet::EMPTY, None);
                return Ok(Next::Continue);
            }
            let reactions = reactions(self.layout(), &vec![0.0; self.layout().reactions()]);
            let start = Event { reactions, note: Some(Note::BeforeImpact), ..start };
            self.transition.events.insert(0, start);
            return self.follow_start(before);
        }
        self.record(EventKind::Start, ContactSet::EMPTY, Some(Note::BeforeImpact));
        if !self.terminal(striking).is_empty() {
            self.record(EventKind::Close, striking, None);
            return Ok(Next::Finished);
        }
        let before = self.before_event();
        self.resolve_impact(striking)?;
        self.follow_start(before)
    }

    /// What an impact at the start makes true at once. What else holds at a start is told.
    fn follow_start(&mut self, before: Option<Before>) -> Result<Next, RunCause> {
        let is_other = |k: &usize| !matches!(self.awaited.role(*k), Role::Switch { .. });
        let others: Vec<Guard> = self.awaited.places().filter(is_other).map(Guard::Condition).collect();
        self.follow_jumps(before, &others)
    }

    /// Logs the conditions that are to end the run and hold at its start.
    fn log_met_conditions(&mut self) {
        let conditions = &self.setup.ends.conditions;
        if conditions.is_empty() {
            return;
        }
        let (context, point) = (&self.setup.context, self.point());
        let met: Vec<Condition> = conditions.iter().filter(|it| it.holds(context, &point)).cloned().collect();
        met.into_iter().for_each(|condition| self.log(LoggedDecision::ConditionHolds(condition)));
    }

    /// Decides on the contacts. A reaction that vanishes, as that of a state at which another run
    /// was left, is zero to within its bound, and its change may be; if it is not known then what
    /// would follow, the contact stays closed as long as it is.
    fn decide_at_start(&mut self) -> Result<(), RunCause> {
        let touching = self.closed();
        let question = DecisionInput { is_given: true, ..DecisionInput::about(touching) };
        let Err(error) = self.go_on(question.clone()) else { return Ok(()) };
        let (reactions, bound) = self.reactions_at(&self.state, touching);
        let free = touching.difference(self.contacts.held());
        let unloaded: ContactSet = free.iter().filter(|i| reactions[*i].abs() <= bound).collect();
        // What an impulse has changed is no longer what was given.
        if unloaded.is_empty() || self.onset.is_struck {
            return Err(error);
        }
        if let Ok(decision) = self.decide(&DecisionInput { unloaded, ..question }) {
            self.adopt(decision);
            return Ok(());
        }
        let slides = self.layout().sliding(&self.slipping_as_now(touching)).next().is_some();
        if slides || free.iter().any(|i| reactions[i] < -bound) {
            return Err(error);
        }
        let entry = self.enter(touching, true)?;
        self.reactions = reactions;
        self.adopt_entry(entry);
        Ok(())
    }

    /// Contacts with g = 0 > ġ at the start, and rough ones that slip and are pressed.
    fn striking(&self) -> ContactSet {
        let context = &self.setup.context;
        let (contacts, touching) = (self.layout().contacts.len(), self.closed());
        if touching.len() == contacts {
            return ContactSet::EMPTY;
        }
        let equations = context.system().equations(&self.state);
        let n = self.layout().coordinates.len();
        let (positions, rates) = (&self.state[..n], &self.state[n..2 * n]);
        let range = [deepest(self.setup.tolerance), CLOSED];
        let is_pressed = |i: usize| {
            self.layout().contacts[i].rough
                && equations.gap_rate(i, rates) <= SOLVED * equations.terms(i, rates)
                && equations.gap_acceleration(i, &self.accelerations(&self.state, touching)) < 0.0
        };
        let closes = |i: &usize| {
            !touching.contains(*i)
                && !self.layout().contacts[*i].kind.is_drive()
                && !self.contacts.absent().contains(*i)
                && touches(context, &equations, (*i, positions), range)
                && (equations.gap_rate(*i, rates) < 0.0 || is_pressed(*i))
        };
        (0..contacts).filter(closes).collect()
    }

    /// Refuses a start in equilibrium unless something is planned: nothing would ever set it in
    /// motion. Where a time is given at which the run ends, it stays there, which is logged. What
    /// an impact without collision has brought to rest did move, and where friction allows another
    /// motion too, rest is one that was taken.
    fn refuse_equilibrium(&mut self) -> Result<(), RunCause> {
        let is_one_of_several =
            |entry: &LogEntry| matches!(entry.decision, LoggedDecision::SeveralMotions { .. });
        let moves = !self.transition.events.is_empty()
            || !self.setup.plan.is_empty()
            || self.transition.log.iter().any(is_one_of_several)
            || !self.setup.rules.switches.is_empty();
        if !moves && is_equilibrium(&self.setup.context, &*self.phase, &self.state) {
            if !self.setup.ends_at_a_time() {
                return Err(StartError::Equilibrium.into());
            }
            self.log(LoggedDecision::StartRests);
        }
        Ok(())
    }
}
