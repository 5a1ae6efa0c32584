//! Contacts that come to rest at the end of their impacts. Their last impacts and the phase up to
//! t∞ have the same impulses, the normal ones as those of friction: a contact that slides all along
//! has borne P_t = −σ μ P in each of them, one that stops before t∞ ends with v = 0.

use nalgebra::DVector;

use crate::contact::impulse::{Collision, CollisionError, Outcome};
use crate::event::{EventKind, Note};
use crate::model::{ContactSet, Slip};
use crate::simulation::RunCause;
use crate::simulation::respond::collide::allowed_gain;
use crate::simulation::snapshot::{Snapshot, ZenoClosure, split};
use crate::trajectory::LoggedDecision;

impl ZenoClosure {
    /// Those that end at one time as far as is known are one. A contact of several is at rest when
    /// the last of them ends.
    pub(super) fn joined(mut all: Vec<Self>, bound: f64) -> Vec<Self> {
        all.sort_by(|one, other| other.end.total_cmp(&one.end));
        let mut joined: Vec<Self> = Vec::new();
        for mut settling in all {
            joined.iter().for_each(|later| settling.set = settling.set.difference(later.set));
            if !settling.set.is_empty() && !joined.iter_mut().any(|later| later.join(&settling, bound)) {
                joined.push(settling);
            }
        }
        joined
    }

    fn join(&mut self, earlier: &Self, bound: f64) -> bool {
        let joins = (self.end - earlier.end).abs() <= bound.max(self.error).max(earlier.error);
        if joins {
            self.error = self.error.max(earlier.error);
            self.set = self.set.union(earlier.set);
        }
        joins
    }
}

impl Snapshot<'_> {
    /// Closes the contacts now; the events are recorded at the times at which their impacts would
    /// have ended.
    pub(super) fn settle(&mut self, settles: Vec<ZenoClosure>) -> Result<(), RunCause> {
        let set = settles.iter().fold(ContactSet::EMPTY, |set, settling| set.union(settling.set));
        let end = settles.iter().map(|settling| settling.end).fold(self.t, f64::max);
        let equations = self.setup.context.system().equations(&self.state);
        let (closed, present) = (self.closed().union(set), self.present(set, &equations));
        let collision = self.collision(present, &equations);
        let outcome =
            self.rest(&collision, closed, end).map_err(|error| self.collision_error(error, present))?;
        let stay = outcome.acting.iter().copied().filter(|&i| outcome.opening[i] == 0.0);
        let struck = stay.collect::<ContactSet>().difference(closed);
        let energy = self.setup.context.system().energy(&self.state);
        self.proceed(&outcome.rates, closed.union(struck))?;
        self.refuse_gain(&energy, allowed_gain(collision.prescribed_gap_rate.as_slice(), &outcome))?;
        if let Some(gained) = self.gained(&outcome) {
            self.log(LoggedDecision::FrictionAhead(gained));
        }
        let (threads, supports) = split(self.layout(), struck);
        self.record_some(EventKind::Impact, supports);
        self.record_some(EventKind::Taut, threads);
        for contact in set.iter() {
            self.bounces.finish(contact);
        }
        self.bounces.keep_settling(|settling| settling.difference(set));
        self.bounces.settling.extend(settles);
        self.record_settled(ContactSet::EMPTY);
        Ok(())
    }

    /// The motion with contacts closed that slip until `end` as they do now, but for those that
    /// friction stops before.
    fn rest(&self, collision: &Collision, closed: ContactSet, end: f64) -> Result<Outcome, CollisionError> {
        let mut set = self.slipping_as_now(closed);
        loop {
            let outcome = (self.setup.parts.laws.come_to_rest)(collision, &set, self.setup.budget.trials)?;
            let stopped = self.stopped_at(&outcome.rates, set, end);
            if stopped.is_empty() {
                return Ok(outcome);
            }
            set = stopped.iter().fold(set, |set, contact| set.slipping(contact, Slip::Stick));
        }
    }

    /// The contacts that slide in a set and, with these rates now, do so the other way at `end`.
    fn stopped_at(&self, rates: &DVector<f64>, set: ContactSet, end: f64) -> ContactSet {
        if self.layout().sliding(&set).next().is_none() {
            return ContactSet::EMPTY;
        }
        let n = rates.len();
        let mut state = self.state.clone();
        state[n..2 * n].copy_from_slice(rates.as_slice());
        let a = self.accelerations(&state, set);
        let equations = self.setup.context.system().equations(&state);
        let velocity = |row: usize| {
            equations.gap_rate(row, rates.as_slice()) + equations.gap_acceleration(row, &a) * (end - self.t)
        };
        let stops = |contact: usize, row: usize| set.slip(contact).sign() as f64 * velocity(row) <= 0.0;
        let sliding = self.layout().sliding(&set).map(|(_, friction)| friction);
        sliding.filter(|friction| stops(friction.contact, friction.row)).map(|it| it.contact).collect()
    }

    /// Records the sequences of impacts that have come to their end, and those of contacts that now
    /// open.
    pub(in crate::simulation) fn record_settled(&mut self, opening: ContactSet) {
        let (t, bound) = (self.t, self.relative_bound() * self.setup.context.scales.time);
        let over =
            |settling: &mut ZenoClosure| settling.end <= t || !settling.set.intersection(opening).is_empty();
        for ZenoClosure { set, error, .. } in self.bounces.settling.extract_if(.., over).collect::<Vec<_>>() {
            let note = (error > bound).then_some(Note::TimeWithin(error));
            self.record(EventKind::Settle, set.intersection(self.closed()), note);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn closure(end: f64, contacts: &[usize]) -> ZenoClosure {
        ZenoClosure { end, error: 0.0, set: contacts.iter().copied().collect() }
    }

    fn join(all: Vec<ZenoClosure>, bound: f64) -> Vec<(f64, ContactSet)> {
        ZenoClosure::joined(all, bound).iter().map(|it| (it.end, it.set)).collect()
    }

    /// A contact of several sequences is at rest when the last of them ends.
    #[test]
    fn the_last_of_its_sequences_brings_a_contact_to_rest() {
        let [early, late] = [closure(1.0, &[0, 1]), closure(2.0, &[1, 2])];
        for all in [vec![early, late], vec![late, early]] {
            let expected = [(2.0, [1, 2].into_iter().collect()), (1.0, ContactSet::EMPTY.with(0))];
            assert_eq!(join(all, 1e-3), expected);
        }
        assert_eq!(join(vec![closure(1.0, &[1]), closure(2.0, &[1])], 1e-3).len(), 1);
    }

    /// Sequences that end at one time, as far as their ends are known, are one.
    #[test]
    fn sequences_that_end_together_are_one() {
        let all = |error| vec![ZenoClosure { error, ..closure(1.0, &[0]) }, closure(1.01, &[1])];
        assert_eq!(join(all(0.0), 0.001).len(), 2);
        for (error, bound) in [(0.02, 0.001), (0.0, 0.02)] {
            let both = ZenoClosure::joined(all(error), bound);
            assert!(both.len() == 1 && both[0].set.len() == 2 && both[0].error == error, "{both:?}");
        }
    }
}
