//! A step with its samples, and what counts as zero there.

use std::cell::RefCell;

use super::GuardBounds;
use super::sample::{Quantities, Sample, Scratch};
use super::samples::Samples;
use super::step::StepView;
use crate::context::Numbers;
use crate::expression::Condition;
use crate::model::Layout;
use crate::numerics::zero::MARGIN;

/// A reaction that touches zero to within this fraction of its bound is known not to cross it.
const CERTAIN: f64 = 1.0 / 64.0;

/// Sizes of the guards of a phase.
pub(crate) struct Scales<'a> {
    pub(super) bounds: GuardBounds,
    pub(super) layout: &'static Layout,
    /// The size of each reaction.
    pub(super) forces: &'a [f64],
    /// The natural slip velocity of each contact with friction.
    pub(super) slips: &'a [f64],
    /// Roundoff of each gap in the step, in its own unit; none where that is less than
    /// any of their bounds.
    pub(super) roundings: Numbers,
}

impl Scales<'_> {
    /// The unit of a gap, or that of which the relative bound is its rounding.
    pub(super) fn size_of_gap(&self, contact: usize) -> f64 {
        let rounding = self.roundings.get(contact).map_or(0.0, |rounding| rounding / self.bounds.relative);
        self.layout.unit(contact, self.bounds.length) * rounding.max(1.0)
    }

    /// How near a foot to the end of its bar is at the end.
    pub(super) fn end(&self) -> f64 {
        self.bounds.relative * self.bounds.length
    }

    /// Whether a gap is so small that its rounding matters, or within its bound.
    pub(super) fn is_low(&self, contact: usize, gap: f64) -> bool {
        gap <= self.bounds.relative.max(MARGIN) * self.layout.unit(contact, self.bounds.length)
    }

    /// Whether what touches zero with a value may as well have crossed it: it differs from zero by
    /// more than rounding.
    pub(super) fn may_cross(&self, value: f64, size: f64) -> bool {
        value.abs() > CERTAIN * self.bounds.relative * size
    }
}

/// A step as guards see it.
#[derive(Clone, Copy)]
pub(crate) struct SampledStep<'s> {
    pub(super) view: &'s StepView<'s>,
    pub(super) samples: &'s RefCell<Samples>,
    pub(super) scales: &'s Scales<'s>,
}

impl SampledStep<'_> {
    /// A value at θ, of a sample of what it follows from.
    pub(super) fn value(&self, theta: f64, asked: Quantities, of: impl FnOnce(&Sample) -> f64) -> f64 {
        of(self.samples.borrow_mut().evaluate(self.view, theta, asked))
    }

    /// The gap of a contact at θ.
    pub(super) fn gap(&self, contact: usize, theta: f64) -> f64 {
        self.value(theta, Quantities::GAPS, |sample| sample.gaps[contact])
    }

    /// What the step itself evaluates.
    pub(super) fn evaluate<T>(&self, of: impl FnOnce(&StepView<'_>, &mut Scratch) -> T) -> T {
        of(self.view, &mut self.samples.borrow_mut().scratch)
    }

    /// How far a foot is from the nearer end of its bar, infinite of none.
    pub(super) fn margin(&self, foot: Option<usize>, theta: f64) -> f64 {
        let Some(foot) = foot else { return f64::INFINITY };
        let nearer = |sample: &Sample| {
            sample.feet[2 * foot..2 * foot + 2].iter().copied().fold(f64::INFINITY, f64::min)
        };
        self.value(theta, Quantities::FEET, nearer)
    }

    /// Whether a foot is under its bar, or there is none.
    pub(super) fn is_under_bar(&self, foot: Option<usize>, theta: f64) -> bool {
        self.margin(foot, theta) >= -self.scales.end()
    }

    /// g̈ of a contact at θ.
    pub(super) fn gap_acceleration(&self, theta: f64, contact: usize) -> f64 {
        self.evaluate(|view, scratch| view.gap_acceleration(theta, contact, scratch))
    }

    /// The difference of a condition's sides at θ, and the larger of them.
    pub(super) fn difference(&self, theta: f64, condition: &Condition) -> (f64, f64) {
        self.evaluate(|view, scratch| view.difference(theta, condition, scratch))
    }
}
