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
//!
//! Contacts that take turns have sequences of such sequences. The fastest flights of each are one that ends the same way
//! ([`sequence`]), and those that end at one time come to rest together ([`rest`]).

mod rest;
mod sequence;

use smallvec::smallvec;

pub(super) use rest::ZenoClosure;
use sequence::Sequence;

use super::Driver;
use crate::contact::impulse::Outcome;
use crate::context::{CLOSED, Numbers};
use crate::model::ContactSet;
use crate::simulation::{Exhausted, RunCause, Simulation};
use crate::system::Equations;

/// A flight that rises less than this, in natural lengths or of the terms of its gap, cannot be followed: a gap has some roundings of one.
const RESOLVED: f64 = 256.0 * f64::EPSILON;
/// A contact falls if it does so by more than this part of the natural acceleration: one that lifts off with its reaction at
/// zero has none but rounding.
const FALLS: f64 = 1e-6;
/// A sequence converges if its end is known to this part of the time that is left.
const CONVERGED: f64 = 1e-2;

/// A contact that leaves its support and falls back.
pub(super) struct Rise {
    contact: usize,
    /// ġ and −g̈ of its gap.
    rate: f64,
    fall: f64,
    /// How high it will be, and how high it must be to be followed.
    height: f64,
    least: f64,
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

/// What follows an impact for a contact that bounces off.
enum BounceOutcome {
    Flies,
    /// Its impacts end at a time known with an error.
    Settles(ZenoClosure),
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

    /// A contact has come to rest.
    fn finish(&mut self, contact: usize) {
        self.sequences[contact].finish();
        self.end(contact);
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
            match self.fate(contact, speed, outcome.factor_of(contact)) {
                BounceOutcome::Flies => {}
                BounceOutcome::Settles(settling) => settles.push(settling),
                BounceOutcome::Lost => return Err(self.accumulation(&[contact])),
            }
        }
        // Those that the impact has opened again do not settle.
        let closed = self.closed;
        self.settling.retain_mut(|settling| {
            settling.set = settling.set.intersection(closed);
            !settling.set.is_empty()
        });
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

    fn accumulation(&self, contacts: &[usize]) -> RunCause {
        let contacts = contacts.iter().map(|&i| self.layout().contacts[i].label.to_owned()).collect();
        RunCause::Accumulation { t: self.t, contacts }
    }

    fn fate(&mut self, contact: usize, speed: f64, factor: f64) -> BounceOutcome {
        let equations = self.setup.context.system().equations(&self.state);
        let fall = -equations.gap_acceleration(contact, &self.accelerations(&self.state, self.bearing));
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
            // Too low for another flight: the contact's own restitution is all there is to go by. Where the flights of
            // several contacts disturb one another the end is known to the time that is left.
            irregular => {
                let e = factor * self.restitution(contact);
                let rest = 2.0 * speed / fall / (1.0 - e);
                let error = if irregular.is_some() { rest } else { 0.0 };
                if e < 1.0 { settles((self.t + rest, error)) } else { BounceOutcome::Lost }
            }
        }
    }

    /// The height below which a flight is lost in the rounding of its gap.
    fn resolved(&self, contact: usize, equations: &Equations<f64>) -> f64 {
        let terms = equations.terms(contact, &self.state[..self.layout().coordinates.len()]);
        RESOLVED * terms.max(self.setup.context.scales.length)
    }

    /// Whether an end is known, and so near that it may be taken for now. One that has passed is of flights before.
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
        let near = self.near(&self.gaps());
        ZenoClosure { end, error, set: near.iter().filter(joins).collect() }
    }

    /// Open contacts with the heights that they are to reach: those that bounce, and those that rise within the bound of their
    /// gap, where their fall would be lost.
    pub(super) fn low_flights(&mut self) -> Vec<(usize, f64)> {
        let known = self.risen.take().filter(|(bearing, _)| *bearing == self.bearing);
        let rising = known.map_or_else(|| self.rising(), |(_, rising)| rising);
        let mut flights = self.bounces.heights.clone();
        // One that is no higher than the rounding of its gap cannot be followed.
        for Rise { contact, height, .. } in rising.into_iter().filter(|rise| rise.height > rise.least) {
            if flights.iter().all(|(known, _)| *known != contact) {
                flights.push((contact, height));
            }
        }
        if self.t == self.setup.begin {
            flights.extend(self.falling_at_start());
        }
        flights
    }

    /// Open contacts that begin the run within the bound of their gap and do not rise, with the height that they fall from: it is
    /// given, and known better than what an integration leaves.
    fn falling_at_start(&self) -> Vec<(usize, f64)> {
        let gaps = self.gaps();
        let low = self.near(&gaps).difference(self.closed).difference(self.layout().drives());
        if low.is_empty() {
            return Vec::new();
        }
        let context = &self.setup.context;
        let (equations, rates) = (context.system().equations(&self.state), &self.state[context.rates()]);
        let falls =
            |i: &usize| gaps[*i] > CLOSED * context.scales.length && equations.gap_rate(*i, rates) <= 0.0;
        low.iter().filter(falls).map(|i| (i, gaps[i])).collect()
    }

    /// Closes open contacts that rise too little to be seen: they are back at once, and their impacts over.
    pub(super) fn settle_unseen(&mut self) -> Result<(), RunCause> {
        let scales = self.setup.context.scales;
        let e = |contact: usize| self.restitution(contact);
        let unseen = |rise: &Rise| {
            let falls = rise.fall > FALLS * scales.acceleration();
            rise.rate > 0.0 && falls && rise.height <= rise.least && e(rise.contact) < 1.0
        };
        let rising = self.rising();
        let low = rising.iter().filter(|rise| unseen(rise)).map(|&Rise { contact, rate, fall, .. }| {
            let rest = 2.0 * rate / fall / (1.0 - e(contact));
            ZenoClosure { end: self.t + rest, error: 0.0, set: ContactSet::EMPTY.with(contact) }
        });
        let low: Vec<ZenoClosure> = low.collect();
        if !low.is_empty() {
            return self.settle(low);
        }
        self.risen = Some((self.bearing, rising));
        Ok(())
    }

    pub(super) fn gaps(&self) -> Numbers {
        let mut gaps: Numbers = smallvec![0.0; self.layout().contacts.len()];
        self.setup.context.system().gaps(&self.state, &mut gaps);
        gaps
    }

    /// Contacts within the bound of their gaps. A foot that has slid off the end of its bar has nothing to fall back on.
    fn near(&self, gaps: &[f64]) -> ContactSet {
        let bound = self.gap_bounds();
        let near: ContactSet = (0..gaps.len()).filter(|i| gaps[*i].abs() <= bound(*i)).collect();
        if near.is_empty() { near } else { near.difference(self.removed.union(self.beyond_end())) }
    }

    /// Open contacts within the bound of their gaps, above their bars, that do not approach their supports but will fall back.
    fn rising(&self) -> Vec<Rise> {
        let (gaps, n) = (self.gaps(), self.layout().coordinates.len());
        let near = self.near(&gaps).difference(self.closed);
        if near.is_empty() {
            return Vec::new();
        }
        let equations = self.setup.context.system().equations(&self.state);
        let a = self.accelerations(&self.state, self.bearing);
        let rise = |contact: usize| {
            let rate = equations.gap_rate(contact, &self.state[n..2 * n]);
            let fall = -equations.gap_acceleration(contact, &a);
            let height = gaps[contact].max(0.0) + 0.5 * rate * rate / fall;
            Rise { contact, rate, fall, height, least: self.resolved(contact, &equations) }
        };
        near.iter().map(rise).filter(|rise| rise.rate >= 0.0 && rise.fall > 0.0).collect()
    }
}
