//! Sequences of impacts that come to their end in finite time. Flights of one contact begin at t₁, t₂, … with the speeds v₁,
//! v₂, …; where both shrink by one factor q, the sequence ends at
//!
//! ```text
//! t∞ = tₙ + q (tₙ − tₙ₋₁)/(1 − q),    q = vₙ/vₙ₋₁
//! ```
//!
//! for a bouncing point, whose q is e, as for a rocking block, which stands between its flights. The last impacts are
//! then replaced by one plastic impact and a closed phase up to t∞: their impulses sum up to those of that phase, with
//! an error of the order of the square of the time they take. What t∞ changes from one flight to the next is its error;
//! below some height the rounding of the gap, divided by v, is all that is left of it, and the best t∞ so far is taken.

use nalgebra::DVector;

use smallvec::smallvec;

use super::Driver;
use super::collide::allowed_gain;
use super::plan::split;
use crate::contact::impulse::{Collision, Outcome, Row};
use crate::error::RunCause;
use crate::event::{EventKind, Note};
use crate::integration::phase_point::Numbers;
use crate::model::ContactSet;
use crate::simulation::Exhausted;

/// A flight that rises less than this, in natural lengths, cannot be followed: a gap has some roundings of one.
const RESOLVED: f64 = 256.0 * f64::EPSILON;
/// A contact falls if it does so by more than this part of the natural acceleration: one that lifts off with its reaction at
/// zero has none but rounding.
const FALLS: f64 = 1e-6;
/// A sequence converges if its end is known to this part of the time that is left.
const CONVERGED: f64 = 1e-2;

/// The flights of one contact since it began to bounce.
#[derive(Debug, Clone, Default)]
struct Sequence {
    /// Start and speed of the last one.
    last: Option<(f64, f64)>,
    /// The end as told by the last two flights.
    end: Option<f64>,
    /// The end least changed from one flight to the next, and that change.
    best: Option<(f64, f64)>,
}

impl Sequence {
    fn begin(&mut self, t: f64, speed: f64) {
        let before = self.last.replace((t, speed));
        let end = before.filter(|(_, v)| speed < *v).map(|(since, v)| {
            let q = speed / v;
            t + q * (t - since) / (1.0 - q)
        });
        let change = self.end.zip(end).map(|(earlier, now)| (now, (now - earlier).abs()));
        let better = |(_, error): &(f64, f64)| self.best.is_none_or(|(_, least)| *error <= least);
        self.best = change.filter(better).or(self.best);
        self.end = end;
    }
}

/// A contact that leaves its support and falls back.
struct Rise {
    contact: usize,
    /// ġ and −g̈ of its gap.
    rate: f64,
    fall: f64,
    /// How high it will be.
    height: f64,
}

/// The flights of all contacts since they began to bounce.
pub(super) struct BounceHistory {
    sequences: Vec<Sequence>,
    /// Contacts in flight, with the height that they are to reach.
    pub(super) heights: Vec<(usize, f64)>,
    /// Impacts since the time given.
    impacts: usize,
    since: f64,
}

/// Contacts whose impacts have been cut short, of which those end at one time.
#[derive(Debug, Clone, Copy)]
pub(super) struct ZenoClosure {
    /// When they would have ended, and the error of that time.
    pub(super) end: f64,
    error: f64,
    set: ContactSet,
}

impl ZenoClosure {
    /// Joins another one, if the two end at one time as far as is known.
    fn join(&mut self, other: &Self, bound: f64) -> bool {
        let joins = (self.end - other.end).abs() <= bound.max(self.error).max(other.error);
        if joins {
            self.end = self.end.max(other.end);
            self.error = self.error.max(other.error);
            self.set = self.set.union(other.set);
        }
        joins
    }
}

/// What follows an impact for a contact that bounces off.
enum BounceOutcome {
    Flies,
    /// Its impacts end at a time known with an error.
    Settles {
        end: f64,
        error: f64,
    },
    Lost,
}

impl BounceHistory {
    pub(super) fn new(contacts: usize) -> Self {
        Self { sequences: vec![Sequence::default(); contacts], heights: Vec::new(), impacts: 0, since: 0.0 }
    }

    fn begin(&mut self, contact: usize, (t, speed, height): (f64, f64, f64)) {
        self.sequences[contact].begin(t, speed);
        self.end(contact);
        self.heights.push((contact, height));
    }

    fn end(&mut self, contact: usize) {
        self.heights.retain(|(i, _)| *i != contact);
    }
}

impl Driver<'_> {
    /// Updates the bounce histories of the contacts that an impact has opened.
    pub(super) fn follow_flights(&mut self, present: ContactSet, outcome: &Outcome) -> Result<(), RunCause> {
        self.count_impact()?;
        let mut settles: Vec<ZenoClosure> = Vec::new();
        let bound = self.relative_bound() * self.setup.context.scales.time;
        for contact in present.iter() {
            self.bounces.end(contact);
            let speed = outcome.opening[contact];
            if speed <= 0.0 || self.closed.contains(contact) {
                continue;
            }
            match self.fate(contact, speed, outcome.factor) {
                BounceOutcome::Flies => {}
                BounceOutcome::Settles { end, error } => {
                    let settling = ZenoClosure { end, error, set: ContactSet::EMPTY.with(contact) };
                    if !settles.iter_mut().any(|other| other.join(&settling, bound)) {
                        settles.push(settling);
                    }
                }
                BounceOutcome::Lost => return Err(self.accumulation(&[contact])),
            }
        }
        // Those that the impact has opened again do not settle.
        let closed = self.closed;
        self.settling.retain_mut(|settling| {
            settling.set = settling.set.intersection(closed);
            !settling.set.is_empty()
        });
        if settles.is_empty() { Ok(()) } else { self.settle(settles) }
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

    fn accumulation(&self, contacts: &[usize]) -> RunCause {
        let contacts = contacts.iter().map(|&i| self.layout().contacts[i].label.to_owned()).collect();
        RunCause::Accumulation { t: self.t, contacts }
    }

    fn fate(&mut self, contact: usize, speed: f64, factor: f64) -> BounceOutcome {
        let equations = self.setup.context.system().equations(&self.state);
        let fall = -equations.gap_acceleration(contact, &self.accelerations());
        if fall <= 0.0 {
            self.bounces.sequences[contact] = Sequence::default();
            return BounceOutcome::Flies;
        }
        let height = 0.5 * speed * speed / fall;
        self.bounces.begin(contact, (self.t, speed, height));
        let scales = &self.setup.context.scales;
        let followed = height > RESOLVED * scales.length;
        let short = self.setup.tolerance.sqrt() * scales.time;
        let close = self.relative_bound() * scales.time;
        match self.bounces.sequences[contact].best {
            Some((end, error)) if error <= close && end - self.t <= short => {
                BounceOutcome::Settles { end, error }
            }
            _ if followed => BounceOutcome::Flies,
            Some((end, error)) if error <= CONVERGED * (end - self.t) => {
                BounceOutcome::Settles { end, error }
            }
            // Too low for another flight: the contact's own restitution is all there is to go by. Where the flights of
            // several contacts disturb one another the end is known to the time that is left.
            irregular => {
                let e = factor * self.restitution(contact);
                let rest = 2.0 * speed / fall / (1.0 - e);
                let error = if irregular.is_some() { rest } else { 0.0 };
                if e < 1.0 {
                    BounceOutcome::Settles { end: self.t + rest, error }
                } else {
                    BounceOutcome::Lost
                }
            }
        }
    }

    /// Open contacts with the heights that they are to reach: those that bounce, and those that rise within the bound of their
    /// gap, where their fall would be lost.
    pub(super) fn low_flights(&self) -> Vec<(usize, f64)> {
        let mut flights = self.bounces.heights.clone();
        // One that is no higher than the rounding of its gap cannot be followed.
        let resolved = RESOLVED * self.setup.context.scales.length;
        let rising = self.rising().into_iter().filter(|rise| rise.height > resolved);
        for Rise { contact, height, .. } in rising {
            if flights.iter().all(|(known, _)| *known != contact) {
                flights.push((contact, height));
            }
        }
        flights
    }

    /// Closes open contacts that rise too little to be seen: they are back at once, and their impacts over.
    pub(super) fn settle_unseen(&mut self) -> Result<(), RunCause> {
        let scales = self.setup.context.scales;
        let e = |contact: usize| self.restitution(contact);
        let unseen = |rise: &Rise| {
            let falls = rise.fall > FALLS * scales.acceleration();
            rise.rate > 0.0 && falls && rise.height <= RESOLVED * scales.length && e(rise.contact) < 1.0
        };
        let low = self.rising().into_iter().filter(unseen).map(|Rise { contact, rate, fall, .. }| {
            let rest = 2.0 * rate / fall / (1.0 - e(contact));
            ZenoClosure { end: self.t + rest, error: 0.0, set: ContactSet::EMPTY.with(contact) }
        });
        let low: Vec<ZenoClosure> = low.collect();
        if low.is_empty() { Ok(()) } else { self.settle(low) }
    }

    /// Open contacts within the bound of their gaps, above their bars, that do not approach their supports but will fall back.
    fn rising(&self) -> Vec<Rise> {
        let context = &self.setup.context;
        let (layout, n) = (self.layout(), self.layout().coordinates.len());
        let mut gaps: Numbers = smallvec![0.0; layout.contacts.len()];
        context.system().gaps(&self.state, &mut gaps);
        let bound = self.relative_bound() * context.scales.length;
        // A foot that has slid off the end of its bar has nothing to fall back on.
        let away = self.closed.union(self.removed).union(self.beyond_end());
        let open = |i: &usize| !away.contains(*i);
        let near: Vec<usize> = (0..gaps.len()).filter(open).filter(|i| gaps[*i].abs() <= bound).collect();
        if near.is_empty() {
            return Vec::new();
        }
        let equations = context.system().equations(&self.state);
        let a = self.accelerations();
        let rise = |contact: usize| {
            let rate = equations.gap_rate(contact, &self.state[n..2 * n]);
            let fall = -equations.gap_acceleration(contact, &a);
            let height = gaps[contact].max(0.0) + 0.5 * rate * rate / fall;
            Rise { contact, rate, fall, height }
        };
        near.into_iter().map(rise).filter(|rise| rise.rate >= 0.0 && rise.fall > 0.0).collect()
    }

    /// Those of the phase that follows.
    fn accelerations(&self) -> Vec<f64> {
        let mut a = vec![0.0; self.layout().coordinates.len()];
        let mut multipliers = vec![0.0; self.layout().rows()];
        self.setup.context.system().solve(&self.state, self.bearing, &mut a, &mut multipliers);
        a
    }

    /// Closes the contacts now; the events are recorded at the times at which their impacts would have ended.
    fn settle(&mut self, settles: Vec<ZenoClosure>) -> Result<(), RunCause> {
        let set = settles.iter().fold(ContactSet::EMPTY, |set, settling| set.union(settling.set));
        let (closed, present) = (self.closed.union(set), self.present(set));
        let open = self.collision(present, DVector::zeros(self.layout().coordinates.len()));
        let hold = |(i, row): (usize, &Row)| match row {
            Row::Contact { .. } if closed.contains(i) => Row::TwoSided,
            // A contact that is all but closed may be struck by the others' coming to rest.
            Row::Contact { law, .. } => Row::Contact { restitution: 0.0, law: *law },
            other => *other,
        };
        let plastic = Collision { rows: open.rows.iter().enumerate().map(hold).collect(), ..open };
        let most = self.setup.budget.trials;
        let outcome = plastic.solve_within(most).map_err(|error| self.collision_error(error, present))?;
        let stay = outcome.acting.iter().copied().filter(|&i| outcome.opening[i] == 0.0);
        let struck = stay.collect::<ContactSet>().difference(closed);
        let energy = self.setup.context.system().energy(&self.state);
        self.proceed(&outcome.rates, closed.union(struck))?;
        self.refuse_gain(&energy, allowed_gain(&plastic, &outcome))?;
        let (threads, supports) = split(self.layout(), struck);
        self.record_some(EventKind::Impact, supports);
        self.record_some(EventKind::Taut, threads);
        for contact in set.iter() {
            self.bounces.sequences[contact] = Sequence::default();
            self.bounces.end(contact);
        }
        self.settling.extend(settles);
        self.record_settled(ContactSet::EMPTY);
        Ok(())
    }

    /// Records the sequences of impacts that have come to their end, and those of contacts that now open.
    pub(super) fn record_settled(&mut self, opening: ContactSet) {
        let (t, bound) = (self.t, self.relative_bound() * self.setup.context.scales.time);
        let over =
            |settling: &mut ZenoClosure| settling.end <= t || !settling.set.intersection(opening).is_empty();
        for ZenoClosure { set, error, .. } in self.settling.extract_if(.., over).collect::<Vec<_>>() {
            let note = (error > bound).then_some(Note::TimeWithin(error));
            self.record(EventKind::Settle, set.intersection(self.closed), note);
        }
    }
}
