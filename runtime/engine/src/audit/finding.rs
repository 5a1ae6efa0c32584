//! A quantity of a motion and its bound.

use core::fmt;

use crate::context::Scales;
use crate::model::Energy;
use crate::numerics::zero::{MARGIN, SOLVED};
use crate::trajectory::{LogEntry, LoggedDecision};

/// Energies and speeds below this part of natural ones are those of bodies at rest: their rounding
/// is not theirs.
pub(super) const SMALL: f64 = 1e-3;

/// The part of an energy that many steps may change together.
const LARGEST: f64 = 0.1;

/// What is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Positions before and after an event, in natural units, beyond their rounding.
    Jump,
    /// Rates where no impact is, in natural units, relative to the largest above one.
    Kick,
    /// Gaps of closed contacts and of joints, in natural lengths, relative to the largest position
    /// above one.
    Gap,
    /// Their rates, relative to the terms that they are the sum of.
    Rate,
    /// Depths of penetration of open contacts, like gaps.
    Penetration,
    /// Pull of closed contacts, relative to the largest reaction of their phase and to the weight.
    Pull,
    /// The change of energy in a phase less the work done, relative to the largest of kinetic and
    /// potential energy.
    Energy,
    /// The energy gained at an event, likewise.
    Impact,
    /// How much an event is before the one that precedes it, s.
    Order,
}

/// The value of a quantity at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finding {
    /// Time, s.
    pub t: f64,
    /// Of what.
    pub quantity: Quantity,
    /// Its value.
    pub value: f64,
    /// What it may be.
    pub bound: f64,
}

impl Finding {
    /// Whether the value is beyond its bound, or one of them is no number.
    pub fn is_violation(&self) -> bool {
        self.value > self.bound || self.value.is_nan() || self.bound.is_nan()
    }

    pub(super) fn is_worse_than(&self, other: &Self) -> bool {
        let [own, others] = [self, other].map(|finding| finding.value / finding.bound.max(f64::MIN_POSITIVE));
        own.is_nan() || own >= others
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let what = match self.quantity {
            Quantity::Jump => "positions jump by",
            Quantity::Kick => "velocities jump without an impact by",
            Quantity::Gap => "closed contacts and joints are open by",
            Quantity::Rate => "closed contacts and joints part at",
            Quantity::Penetration => "open contacts are penetrated by",
            Quantity::Pull => "closed contacts are pulled at by",
            Quantity::Energy => "the energy of a phase is off by",
            Quantity::Impact => "an event gains an energy of",
            Quantity::Order => "an event is before its predecessor by",
        };
        let value = self.value.max(0.0);
        write!(f, "{what} {value:.1e} of {:.1e} allowed, at t = {}", self.bound, self.t)
    }
}

/// Bounds that follow from the tolerance and the number of steps.
pub(crate) struct AuditBounds {
    /// Local error of a step, not below some roundings.
    error: f64,
    steps: f64,
    /// Singular positions of loops that were passed.
    passages: f64,
}

impl AuditBounds {
    pub(crate) fn new(tolerance: f64, steps: u64) -> Self {
        Self { error: tolerance.max(SOLVED), steps: steps as f64, passages: 0.0 }
    }

    /// The same with singular positions of loops passed by that logged them.
    pub(crate) fn past<'a>(self, log: impl IntoIterator<Item = &'a LogEntry>) -> Self {
        let is_passage = |entry: &&LogEntry| entry.decision == LoggedDecision::SingularPosition;
        Self { passages: log.into_iter().filter(is_passage).count() as f64, ..self }
    }

    /// The energy is quadratic in the rates: some local errors for each step, and for each step
    /// across a singular position of a loop what that leaves of them; a tenth of it is no error of
    /// steps, whatever the tolerance.
    pub(crate) fn energy(&self) -> f64 {
        let of_steps = 100.0 * self.error * (10.0 + self.steps);
        of_steps.min(LARGEST.max(10.0 * self.error)) + 2.0 * MARGIN * self.passages
    }

    /// Events are located to ten local errors, and sequences of impacts are cut short at heights of
    /// a local error in natural lengths, which is a thousand times more of the [`SMALL`] energy
    /// there.
    pub(crate) fn impact(&self) -> f64 {
        1e4 * self.error
    }

    /// Positions within ten local errors leave those of a fold, and rates there, unknown by the
    /// square root.
    pub(crate) fn jump(&self) -> f64 {
        (10.0 * self.error).sqrt()
    }

    pub(crate) fn gap(&self) -> f64 {
        1e3 * self.error
    }

    pub(crate) fn rate(&self) -> f64 {
        self.gap().sqrt()
    }

    pub(crate) fn pull(&self) -> f64 {
        self.gap().sqrt()
    }
}

/// The energy gained beyond what is told, relative to the largest of its parts.
pub(crate) fn gain(scales: &Scales, [before, after]: [&Energy<f64>; 2], told: f64) -> f64 {
    (after.gained_since(before) - told) / largest(scales, before, after)
}

/// The largest of the parts of two energies, and not below [`SMALL`] natural ones.
pub(super) fn largest(scales: &Scales, before: &Energy<f64>, after: &Energy<f64>) -> f64 {
    let parts = [before.kinetic, after.kinetic, before.potential.abs(), after.potential.abs()];
    let least = (SMALL * scales.force() * scales.length).max(f64::MIN_POSITIVE);
    parts.into_iter().fold(least, f64::max)
}
