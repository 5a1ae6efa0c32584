//! Sequences of impacts that come to their end in finite time. Flights of one contact begin at t₁, t₂, …; where their
//! intervals shrink by one factor q, the sequence ends at
//!
//! ```text
//! t∞ = tₙ + q (tₙ − tₙ₋₁)/(1 − q),    q = (tₙ − tₙ₋₁)/(tₙ₋₁ − tₙ₋₂)
//! ```
//!
//! (Aitken's Δ²), for a bouncing point, whose q is e, as for a rocking block, between whose flights it stands. The last
//! impacts are then replaced by one plastic impact and a closed phase up to t∞: their impulses sum up to those of that
//! phase, with an error of the order of the square of the time they take.

use nalgebra::DVector;

use super::Driver;
use crate::contact::impulse::{Collision, Outcome, Row};
use crate::error::RunCause;
use crate::event::EventKind;
use crate::model::{BarSystem, ContactSet, KernelView};

/// A flight that rises less than this, in natural lengths, cannot be followed: a gap has some roundings of one.
const RESOLVED: f64 = 256.0 * f64::EPSILON;
/// So many impacts within one natural time are no motion that can be followed.
const MOST_IMPACTS: usize = 50_000;

/// Flights since contacts began to bounce.
pub(super) struct Flights {
    /// The last four starts of flights of each contact.
    starts: Vec<Vec<f64>>,
    /// Contacts in flight, with the height that they are to reach.
    pub(super) heights: Vec<(usize, f64)>,
    /// Impacts since the time given.
    impacts: usize,
    since: f64,
}

/// What becomes of a contact that is thrown off.
enum Fate {
    Flies,
    /// Its impacts end after so much time.
    Settles(f64),
    Lost,
}

impl Flights {
    pub(super) fn new(contacts: usize) -> Self {
        Self { starts: vec![Vec::new(); contacts], heights: Vec::new(), impacts: 0, since: 0.0 }
    }

    /// The time from now to the end of a contact's impacts, and its error.
    fn remaining(&self, contact: usize) -> Option<(f64, f64)> {
        let [t0, t1, t2, t3] = *self.starts[contact].as_slice() else { return None };
        let rest = |a: f64, b: f64| (0.0 < b && b < a).then(|| b * b / (a - b));
        let (earlier, now) = (rest(t1 - t0, t2 - t1)?, rest(t2 - t1, t3 - t2)?);
        Some((now, (t2 + earlier - t3 - now).abs()))
    }

    fn begin(&mut self, contact: usize, t: f64, height: f64) {
        let starts = &mut self.starts[contact];
        if starts.len() == 4 {
            starts.remove(0);
        }
        starts.push(t);
        self.end(contact);
        self.heights.push((contact, height));
    }

    fn end(&mut self, contact: usize) {
        self.heights.retain(|(i, _)| *i != contact);
    }
}

impl<M: BarSystem> Driver<M> {
    /// Looks where the contacts fly that an impact has thrown off.
    pub(super) fn follow_flights(&mut self, present: ContactSet, outcome: &Outcome) -> Result<(), RunCause> {
        self.count_impact(&outcome.acting)?;
        let mut settles: Option<(f64, ContactSet)> = None;
        for contact in present.iter() {
            self.flights.end(contact);
            let speed = outcome.opening[contact];
            if speed <= 0.0 || self.closed.contains(contact) {
                continue;
            }
            match self.fate(contact, speed, outcome.factor) {
                Fate::Flies => {}
                Fate::Settles(rest) => {
                    let (most, set) = settles.unwrap_or((0.0, ContactSet::EMPTY));
                    settles = Some((rest.max(most), set.with(contact)));
                }
                Fate::Lost => return Err(self.accumulation(&[contact])),
            }
        }
        settles.map_or(Ok(()), |(rest, set)| self.settle(rest, set))
    }

    fn count_impact(&mut self, acting: &[usize]) -> Result<(), RunCause> {
        let flights = &mut self.flights;
        flights.impacts += 1;
        if self.t - flights.since > self.setup.scene.scales.time {
            (flights.since, flights.impacts) = (self.t, 1);
        }
        if flights.impacts > MOST_IMPACTS { Err(self.accumulation(acting)) } else { Ok(()) }
    }

    fn accumulation(&self, contacts: &[usize]) -> RunCause {
        let contacts = contacts.iter().map(|&i| M::LAYOUT.contacts[i].label.to_owned()).collect();
        RunCause::Accumulation { t: self.t, contacts }
    }

    fn fate(&mut self, contact: usize, speed: f64, factor: f64) -> Fate {
        let fall = -self.opening_acceleration(contact);
        if fall <= 0.0 {
            self.flights.starts[contact].clear();
            return Fate::Flies;
        }
        let (height, flight) = (0.5 * speed * speed / fall, 2.0 * speed / fall);
        self.flights.begin(contact, self.t, height);
        let scales = &self.setup.scene.scales;
        let known = self.flights.remaining(contact).filter(|(_, error)| {
            *error <= self.relative_bound() * scales.time.max(f64::EPSILON / self.setup.tolerance * self.t)
        });
        let followed = height > RESOLVED * scales.length;
        match known {
            Some((rest, _)) if rest <= self.setup.tolerance.sqrt() * scales.time || !followed => {
                Fate::Settles(rest)
            }
            _ if followed => Fate::Flies,
            // Too low for a second flight: the contact's own restitution is all there is to go by.
            _ if self.flights.starts[contact].len() < 4 => {
                let e = factor * self.setup.restitution.get(contact).copied().unwrap_or(0.0);
                if e < 1.0 { Fate::Settles(flight / (1.0 - e)) } else { Fate::Lost }
            }
            _ => Fate::Lost,
        }
    }

    /// g̈ of a contact in the phase that follows.
    fn opening_acceleration(&self, contact: usize) -> f64 {
        let kernel = M::kernel(&self.setup.scene.constants, &self.state);
        let mut a = vec![0.0; M::LAYOUT.coordinates.len()];
        let mut multipliers = vec![0.0; M::LAYOUT.rows()];
        kernel.solve(M::LAYOUT, self.closed, &mut a, &mut multipliers);
        let along = kernel.jacobian(contact).iter().zip(&a).map(|(slope, a)| slope * a);
        along.sum::<f64>() + kernel.bias()[contact]
    }

    /// Closes the contacts now, and tells when their impacts would have ended.
    fn settle(&mut self, rest: f64, set: ContactSet) -> Result<(), RunCause> {
        let closed = ContactSet(self.closed.0 | set.0);
        let open = self.collision(closed, DVector::zeros(M::LAYOUT.coordinates.len()));
        let hold = |row: &Row| if matches!(row, Row::Contact { .. }) { Row::TwoSided } else { *row };
        let plastic = Collision { rows: open.rows.iter().map(hold).collect(), ..open };
        let Ok(outcome) = plastic.solve() else { return Ok(()) };
        self.proceed(&outcome.rates, closed)?;
        set.iter().for_each(|contact| {
            self.flights.starts[contact].clear();
            self.flights.end(contact);
        });
        self.settling = Some((self.t + rest, set));
        if self.t + rest == self.t {
            self.record_settled()
        }
        Ok(())
    }

    /// Tells the end of a sequence of impacts.
    pub(super) fn record_settled(&mut self) {
        if let Some((_, set)) = self.settling.take() {
            self.record(EventKind::Settle, ContactSet(set.0 & self.closed.0), None);
        }
    }
}
