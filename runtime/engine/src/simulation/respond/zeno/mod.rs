//! Sequences of impacts that come to their end in finite time. Flights of one contact begin at t₁,
//! t₂, … with the speeds v₁, v₂, …; where both shrink by one factor q, the sequence ends at
//!
//! ```text
//! t∞ = tₙ + q (tₙ − tₙ₋₁)/(1 − q),    q = vₙ/vₙ₋₁
//! ```
//!
//! for a bouncing point, whose q is e, as for a rocking block, which stands between its flights.
//! The last impacts are then replaced by one plastic impact and a closed phase up to t∞: their
//! impulses sum up to those of that phase, with an error of the order of the square of the time
//! they take. What t∞ changes from one flight to the next is its error; below some height the
//! rounding of the gap, divided by v, is all that is left of it, and the best t∞ so far is taken.
//!
//! Contacts that take turns have sequences of such sequences. The fastest flights of each are one
//! that ends the same way ([`sequence`]), and those that end at one time come to rest together
//! ([`rest`]).

mod rest;

use crate::contact::impulse::Outcome;
use crate::contact::labels;
use crate::model::ContactSet;
use crate::numerics::zero::MARGIN;
use crate::simulation::snapshot::{PendingFlight, Sequence, Snapshot, ZenoClosure};
use crate::simulation::{Exhausted, RunCause, Simulation};

/// A sequence converges if its end is known to this part of the time that is left.
const CONVERGED: f64 = 1e-2;

/// What follows an impact for a contact that bounces off.
enum BounceOutcome {
    Flies,
    /// Its impacts end at a time known with an error.
    Settles(ZenoClosure),
    Lost,
}

impl Snapshot<'_> {
    /// Updates the bounce histories of the contacts that an impact has opened.
    pub(super) fn follow_flights(&mut self, present: ContactSet, outcome: &Outcome) -> Result<(), RunCause> {
        self.count_impact()?;
        let mut settles: Vec<ZenoClosure> = Vec::new();
        let bound = self.relative_bound() * self.setup.context.scales.time;
        for contact in present.iter() {
            self.bounces.end(contact);
            let speed = outcome.opening[contact];
            if speed <= 0.0 || self.closed().contains(contact) {
                continue;
            }
            match self.fate(contact, speed, outcome.factor_of(contact)) {
                BounceOutcome::Flies => {}
                BounceOutcome::Settles(settling) => settles.push(settling),
                BounceOutcome::Lost => {
                    let contacts = labels(self.layout(), ContactSet::EMPTY.with(contact));
                    return Err(RunCause::Accumulation { t: self.t, contacts });
                }
            }
        }
        // Those that the impact has opened again do not settle.
        let closed = self.closed();
        self.bounces.keep_settling(|set| set.intersection(closed));
        if settles.is_empty() { Ok(()) } else { self.settle(ZenoClosure::joined(settles, bound)) }
    }

    fn count_impact(&mut self) -> Result<(), RunCause> {
        let flights = &mut self.bounces;
        flights.impacts += 1;
        if self.t - flights.since > self.setup.context.scales.time {
            (flights.since, flights.impacts) = (self.t, 1);
        }
        let most = self.setup.budget.impacts;
        if flights.impacts > most { Err(self.exhausted(Exhausted::Impacts(most))) } else { Ok(()) }
    }

    fn fate(&mut self, contact: usize, speed: f64, factor: f64) -> BounceOutcome {
        let equations = self.setup.context.system().equations(&self.state);
        let fall =
            -equations.gap_acceleration(contact, &self.accelerations(&self.state, self.active_basis()));
        if fall <= 0.0 {
            self.bounces.sequences[contact] = Sequence::default();
            return BounceOutcome::Flies;
        }
        let height = 0.5 * speed * speed / fall;
        self.bounces.begin(contact, (self.t, speed, height));
        let set = ContactSet::EMPTY.with(contact);
        let settles = |(end, error)| BounceOutcome::Settles(ZenoClosure { end, error, set });
        let followed = height > self.resolved(contact, &equations);
        let converged = |(end, error): (f64, f64)| error <= CONVERGED * (end - self.t);
        // Slower flights than the one before are of its own sequence, which may end alone.
        let is_first = !followed && !self.bounces.sequences[contact].slows();
        let ends = |end: &(f64, f64)| self.is_near(*end) || is_first && converged(*end);
        if let Some(end) = self.bounces.sequences[contact].of_fastest().find(ends) {
            return BounceOutcome::Settles(self.end_of_turns(contact, end));
        }
        match self.bounces.sequences[contact].best() {
            Some(end) if self.is_near(end) => settles(end),
            _ if followed => BounceOutcome::Flies,
            Some(end) if converged(end) => settles(end),
            // Too low for another flight: the contact's own restitution is all there is to go by.
            // Where the flights of several contacts disturb one another the end is known to the
            // time that is left.
            irregular => {
                let e = factor * self.restitution(contact);
                let rest = 2.0 * speed / fall / (1.0 - e);
                let error = if irregular.is_some() { rest } else { 0.0 };
                match irregular {
                    _ if e < 1.0 => settles((self.t + rest, error)),
                    // What takes its energy is another contact's impact.
                    Some((end, error)) => settles((end.max(self.t), error.max(end - self.t))),
                    None => BounceOutcome::Lost,
                }
            }
        }
    }

    /// Whether an end is known, and so near that it may be taken for now. One that has passed is of
    /// flights before.
    fn is_near(&self, (end, error): (f64, f64)) -> bool {
        let Simulation { tolerance, context, .. } = self.setup;
        let (short, close) =
            (tolerance.sqrt() * context.scales.time, self.relative_bound() * context.scales.time);
        error <= close && (-close..=short).contains(&(end - self.t))
    }

    /// All contacts whose flights, or the fastest of them, end when the fastest of this one do.
    fn end_of_turns(&self, contact: usize, (end, error): (f64, f64)) -> ZenoClosure {
        let close = self.relative_bound() * self.setup.context.scales.time;
        let same = close.max(error).max(CONVERGED * (end - self.t));
        let joins = |i: &usize| {
            let sequence = &self.bounces.sequences[*i];
            let mut ends = sequence.best().into_iter().chain(sequence.of_fastest());
            *i == contact || ends.any(|(other, by)| (other - end).abs() <= same.max(by))
        };
        let near = self.find_near(&self.gaps());
        ZenoClosure { end, error, set: near.iter().filter(joins).collect() }
    }

    /// Closes open contacts that rise too little to be seen: they are back at once, and their
    /// impacts over.
    pub(in crate::simulation) fn settle_unseen(&mut self) -> Result<(), RunCause> {
        let scales = self.setup.context.scales;
        let e = |contact: usize| self.restitution(contact);
        let unseen = |rise: &PendingFlight| {
            let falls = rise.fall > MARGIN * scales.acceleration();
            rise.rate > 0.0 && falls && rise.height <= rise.least && e(rise.contact) < 1.0
        };
        let rising = self.find_rising();
        let low = rising.iter().filter(|rise| unseen(rise)).map(
            |&PendingFlight { contact, rate, fall, .. }| {
                let rest = 2.0 * rate / fall / (1.0 - e(contact));
                ZenoClosure { end: self.t + rest, error: 0.0, set: ContactSet::EMPTY.with(contact) }
            },
        );
        let low: Vec<ZenoClosure> = low.collect();
        if !low.is_empty() {
            return self.settle(low);
        }
        self.onset.risen = Some((self.active_basis(), rising));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prelude::*;
    use crate::simulation::tests::given::*;

    /// A level sled at rest, whose feet have begun to bounce a while ago with e = 1/2, the first
    /// flights a second long, so that their impacts end two seconds later.
    fn with_ends(ends: [f64; 2], check: impl FnOnce(Snapshot<'_>)) {
        let sled = Sled { m: 3.0, l: 1.0, g: 10.0, mu: 0.25, e: 0.5 };
        let sled = Simulation::new(&sled).unwrap().start(Pose::new("theta", 0.0).with("y", 0.0)).unwrap();
        with_start(&sled.impulse("A", [1.0, 0.0], 9.0).unwrap(), |mut now| {
            for (sequence, end) in now.bounces.sequences.iter_mut().zip(ends) {
                for k in 0..12 {
                    let left = 2.0 * 0.5_f64.powi(k);
                    sequence.begin(end - left, 0.5 * left);
                }
            }
            check(now);
        });
    }

    /// Contacts whose flights end together, to a hundredth of the time that is left, end as one.
    #[test]
    fn contacts_that_take_turns_end_together() {
        for (apart, both) in [(0.0, true), (0.0005, true), (0.05, false)] {
            with_ends([3.0, 3.0 + apart], |mut now| {
                now.t = 2.9;
                let ZenoClosure { end, error, set } = now.end_of_turns(0, (3.0, 1e-12));
                assert_eq!((end, error, set.len()), (3.0, 1e-12, if both { 2 } else { 1 }), "{apart}");
            });
        }
    }

    /// Impacts are counted within one natural time, the time for which a length falls.
    #[test]
    fn impacts_within_a_natural_time_are_counted() {
        let ball = start(&BALL, [1.0, 1.0, 0.0, 0.0])
            .budget(crate::Budget { impacts: 2, ..crate::Budget::UNLIMITED });
        let natural = ball.scales().time;
        with_begun(&ball, |mut ball, _| {
            let mut count = |t: f64| {
                ball.t = t;
                ball.count_impact().is_ok()
            };
            let soon = |k: f64| 9.0 + k * natural;
            // The third within one of them is one too many; later they are counted anew.
            assert_eq!([0.0, 0.3, 0.6].map(|k| count(soon(k))), [true, true, false]);
            assert_eq!([1.5, 1.8, 2.1].map(|k| count(soon(k))), [true, true, false]);
        });
    }
}
