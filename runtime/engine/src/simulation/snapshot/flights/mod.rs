//! Flights between impacts: how contacts bounce, how high they rise, and how high they must be to
//! be followed.

mod sequence;

pub(crate) use sequence::Sequence;

use super::Snapshot;
use crate::context::CLOSED;
use crate::model::ContactSet;
use crate::numerics::zero::roundoff;
use crate::system::Equations;

/// A flight that rises less than this, in natural lengths or of the terms of its gap, cannot be
/// followed: a gap has some roundings of one.
const RESOLVED: f64 = roundoff(256.0);

/// A contact that leaves its support and falls back.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PendingFlight {
    pub(in crate::simulation) contact: usize,
    /// ġ and −g̈ of its gap.
    pub(in crate::simulation) rate: f64,
    pub(in crate::simulation) fall: f64,
    /// How high it will be, and how high it must be to be followed.
    pub(in crate::simulation) height: f64,
    pub(in crate::simulation) least: f64,
}

/// Contacts whose impacts have been cut short, of which those end at one time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ZenoClosure {
    /// When they would have ended, and the error of that time.
    pub(in crate::simulation) end: f64,
    pub(in crate::simulation) error: f64,
    pub(in crate::simulation) set: ContactSet,
}

/// The flights of all contacts since they began to bounce, and those whose impacts have been cut
/// short.
#[derive(Debug)]
pub(crate) struct Bounces {
    pub(in crate::simulation) sequences: Vec<Sequence>,
    /// Contacts in flight, with the height that they are to reach.
    pub(in crate::simulation) heights: Vec<(usize, f64)>,
    pub(in crate::simulation) settling: Vec<ZenoClosure>,
    /// Impacts since the time given.
    pub(in crate::simulation) impacts: usize,
    pub(in crate::simulation) since: f64,
    /// Impacts without collision since time last advanced.
    pub(in crate::simulation) wedged: usize,
}

impl Bounces {
    pub(super) fn new(contacts: usize) -> Self {
        Self {
            sequences: vec![Sequence::default(); contacts],
            heights: Vec::new(),
            settling: Vec::new(),
            impacts: 0,
            since: 0.0,
            wedged: 0,
        }
    }

    pub(in crate::simulation) fn begin(&mut self, contact: usize, (t, speed, height): (f64, f64, f64)) {
        self.sequences[contact].begin(t, speed);
        self.end(contact);
        self.heights.push((contact, height));
    }

    pub(in crate::simulation) fn end(&mut self, contact: usize) {
        self.heights.retain(|(i, _)| *i != contact);
    }

    /// A contact has come to rest.
    pub(in crate::simulation) fn finish(&mut self, contact: usize) {
        self.sequences[contact].finish();
        self.end(contact);
    }

    /// Of the contacts that settle only some go on to.
    pub(in crate::simulation) fn keep_settling(&mut self, some: impl Fn(ContactSet) -> ContactSet) {
        self.settling.retain_mut(|settling| {
            settling.set = some(settling.set);
            !settling.set.is_empty()
        });
    }
}

impl Snapshot<'_> {
    /// Open contacts with the heights that they are to reach: those that bounce, and those that
    /// rise within the bound of their gap, where their fall would be lost.
    pub(in crate::simulation) fn find_low_flights(&self) -> Vec<(usize, f64)> {
        let known = self.onset.risen.as_ref().filter(|(bearing, _)| *bearing == self.active_basis());
        let found = if known.is_none() { self.find_rising() } else { Vec::new() };
        let rising = known.map_or(&found, |(_, rising)| rising);
        let mut flights = self.bounces.heights.clone();
        // One that is no higher than the rounding of its gap cannot be followed.
        for &PendingFlight { contact, height, .. } in rising.iter().filter(|rise| rise.height > rise.least) {
            if flights.iter().all(|(known, _)| *known != contact) {
                flights.push((contact, height));
            }
        }
        if self.t == self.setup.begin {
            flights.extend(self.falling_at_start());
        }
        flights
    }

    /// Open contacts that begin the run within the bound of their gap and do not rise, with the
    /// height that they fall from: it is given, and known better than what an integration leaves.
    fn falling_at_start(&self) -> Vec<(usize, f64)> {
        let gaps = self.gaps();
        let low = self.find_near(&gaps).difference(self.closed()).difference(self.layout().drives());
        if low.is_empty() {
            return Vec::new();
        }
        let context = &self.setup.context;
        let (equations, rates) = (context.system().equations(&self.state), self.rates());
        let unit = |i: usize| self.layout().unit(i, context.scales.length);
        let falls = |i: &usize| gaps[*i] > CLOSED * unit(*i) && equations.gap_rate(*i, rates) <= 0.0;
        low.iter().filter(falls).map(|i| (i, gaps[i])).collect()
    }

    /// Open contacts within the bound of their gaps, above their bars, that do not approach their
    /// supports but will fall back. Of one that lifts off with its reaction at zero g̈ is as well
    /// known as the place of that zero, and grows.
    pub(in crate::simulation) fn find_rising(&self) -> Vec<PendingFlight> {
        let gaps = self.gaps();
        let near =
            self.find_near(&gaps).difference(self.closed()).difference(self.onset.opened_at_zero_reaction);
        if near.is_empty() {
            return Vec::new();
        }
        let equations = self.setup.context.system().equations(&self.state);
        let a = self.accelerations(&self.state, self.active_basis());
        let rise = |contact: usize| {
            let rate = equations.gap_rate(contact, self.rates());
            let fall = -equations.gap_acceleration(contact, &a);
            let height = gaps[contact].max(0.0) + 0.5 * rate * rate / fall;
            PendingFlight { contact, rate, fall, height, least: self.resolved(contact, &equations) }
        };
        near.iter().map(rise).filter(|rise| rise.rate >= 0.0 && rise.fall > 0.0).collect()
    }

    /// Contacts within the bound of their gaps. A foot that has slid off the end of its bar has
    /// nothing to fall back on.
    pub(in crate::simulation) fn find_near(&self, gaps: &[f64]) -> ContactSet {
        let bound = self.gap_bounds();
        let near: ContactSet = (0..gaps.len()).filter(|i| gaps[*i].abs() <= bound(*i)).collect();
        if near.is_empty() {
            near
        } else {
            near.difference(self.contacts.absent().union(self.find_beyond_end()))
        }
    }

    /// The height below which a flight is lost in the rounding of its gap.
    pub(in crate::simulation) fn resolved(&self, contact: usize, equations: &Equations<f64>) -> f64 {
        let terms = equations.terms(contact, &self.state[..self.layout().coordinates.len()]);
        RESOLVED * terms.max(self.layout().unit(contact, self.setup.context.scales.length))
    }
}
