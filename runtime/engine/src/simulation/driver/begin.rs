//! The start of a run.

use std::sync::Arc;

use super::jumps::Before;
use super::{Driver, Next};
use crate::assembly::{StartError, deepest, touches};
use crate::context::{CLOSED, reactions_of};
use crate::event::{Event, EventKind, Guard, Note, reactions};
use crate::expression::Condition;
use crate::integration::equilibrium::is_equilibrium;
use crate::model::ContactSet;
use crate::simulation::awaited::Role;
use crate::simulation::{RunCause, Simulation};
use crate::system::Phase;
use crate::trajectory::{LogEntry, LoggedDecision};

impl Driver<'_> {
    /// The phase of the start, after the impact of what its rates drive into a support, or without collision where they obey no law of
    /// friction.
    pub(super) fn begin(&mut self) -> Result<Next, RunCause> {
        let (before, striking) = (self.before_event(), self.striking());
        let start = self.event(EventKind::Start, ContactSet::EMPTY, None);
        if striking.is_empty() {
            self.decide_at_start()?;
            self.refuse_equilibrium()?;
            if self.trajectory.events.is_empty() {
                self.record(EventKind::Start, ContactSet::EMPTY, None);
                return Ok(Next::Continue);
            }
            let reactions = reactions(self.layout(), &vec![0.0; self.layout().reactions()]);
            let start = Event { reactions, note: Some(Note::BeforeImpact), ..start };
            self.trajectory.events.insert(0, start);
            return self.follow_start(before);
        }
        self.closed = self.touching;
        self.reactions = vec![0.0; self.layout().reactions()];
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
    pub(super) fn tell_met(&mut self) {
        if self.setup.conditions.is_empty() {
            return;
        }
        let (context, point) = (&self.setup.context, self.point());
        let met: Vec<Condition> = self
            .setup
            .conditions
            .iter()
            .filter(|condition| condition.holds(context, &point))
            .cloned()
            .collect();
        met.into_iter().for_each(|condition| self.log(LoggedDecision::ConditionHolds(condition)));
    }

    /// Decides on the contacts. A reaction that vanishes, as that of a state at which another run was left, is zero to within its
    /// bound, and its change may be; if it is not told then what would follow, the contact stays closed as long as it is.
    fn decide_at_start(&mut self) -> Result<(), RunCause> {
        let (touching, given) = (self.touching, self.state.clone());
        let Err(error) = self.decide(ContactSet::EMPTY) else { return Ok(()) };
        let (reactions, bound) = self.reactions_at(&given, touching);
        let vanishes = |i: &usize| reactions[*i].abs() <= bound && !self.is_held(*i);
        let unloaded: ContactSet = touching.iter().filter(vanishes).collect();
        if unloaded.is_empty() {
            return Err(error);
        }
        (self.touching, self.state) = (touching, given.clone());
        if self.decide(unloaded).is_ok() {
            return Ok(());
        }
        if touching.iter().any(|i| reactions[i] < -bound && !self.is_held(i)) {
            return Err(error);
        }
        (self.touching, self.state, self.closed, self.bearing) = (touching, given, touching, touching);
        self.reactions = reactions;
        self.choose_form()
    }

    /// Reactions of contacts with all of a set closed, and what counts as zero.
    pub(super) fn reactions_at(&self, state: &[f64], touching: ContactSet) -> (Vec<f64>, f64) {
        let (context, layout) = (&self.setup.context, self.layout());
        let (mut a, mut multipliers) = (vec![0.0; layout.coordinates.len()], vec![0.0; layout.rows()]);
        context.system().solve(state, touching, &mut a, &mut multipliers);
        let reactions = reactions_of(layout, &multipliers).to_vec();
        let largest = reactions.iter().map(|reaction| reaction.abs()).fold(context.scales.force(), f64::max);
        (reactions, self.relative_bound() * largest)
    }

    /// Contacts with g = 0 > ġ at the start.
    pub(super) fn striking(&self) -> ContactSet {
        let context = &self.setup.context;
        let contacts = self.layout().contacts.len();
        if self.touching.len() == contacts {
            return ContactSet::EMPTY;
        }
        let equations = context.system().equations(&self.state);
        let n = self.layout().coordinates.len();
        let (positions, rates) = (&self.state[..n], &self.state[n..2 * n]);
        let range = [deepest(self.setup.tolerance), CLOSED];
        let closes = |i: &usize| {
            !self.touching.contains(*i)
                && !self.layout().contacts[*i].kind.is_drive()
                && !self.removed.contains(*i)
                && touches(context, &equations, (*i, positions), range)
                && equations.gap_rate(*i, rates) < 0.0
        };
        (0..contacts).filter(closes).collect()
    }

    /// Logs how deep the start asks for contacts to be penetrated, if that is more than the rounding of a pose.
    pub(super) fn tell_depth(&mut self, depth: f64) {
        if depth > CLOSED * self.setup.context.scales.length {
            self.log(LoggedDecision::StartPenetrates(depth));
        }
    }

    pub(super) fn check(&self) -> Result<(), RunCause> {
        let Simulation { tolerance, begin, .. } = *self.setup;
        let limit = self.setup.time_limit();
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(RunCause::Tolerance(tolerance));
        }
        if !(limit > begin && limit.is_finite()) {
            return Err(RunCause::Limit(limit));
        }
        let Some(i) = self.held.iter().find(|&i| !self.touching.contains(i)) else { return Ok(()) };
        let gap = self.setup.context.system().equations(&self.state).gap()[i];
        Err(StartError::HeldOpen { support: self.layout().contacts[i].label.to_owned(), gap }.into())
    }

    /// Refuses a start in equilibrium unless something is planned: nothing would ever set it in motion. What an impact without
    /// collision has brought to rest did move, and where friction allows another motion too, rest is one that was taken.
    pub(super) fn refuse_equilibrium(&self) -> Result<(), RunCause> {
        let rests = |phase: &Arc<dyn Phase>| is_equilibrium(&self.setup.context, &**phase, &self.state);
        let is_one_of_several =
            |entry: &LogEntry| matches!(entry.decision, LoggedDecision::SeveralMotions { .. });
        let moves = !self.trajectory.events.is_empty()
            || !self.setup.plan.is_empty()
            || self.trajectory.log.iter().any(is_one_of_several)
            || !self.setup.rules.switches.is_empty();
        if !moves && self.phase.as_ref().is_some_and(rests) {
            return Err(StartError::Equilibrium.into());
        }
        Ok(())
    }
}
