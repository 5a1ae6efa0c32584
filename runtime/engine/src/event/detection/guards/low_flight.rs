//! Flights of contacts that lift off with their reaction at zero and come back before they are much
//! higher than the rounding of their gap.
//!
//! The gap is lost in rounding there, its acceleration is not: it is as large as the reaction would
//! be. With g = ġ = 0 at the lift-off,
//!
//! ```text
//! g(θ) = g₀ + ġ₀ h θ + h² θ² ∫₀¹ (1 − σ) g̈(θ σ) dσ
//! ```
//!
//! by Gauss's points. Where g̈ stays above zero there is no landing to look for.

use crate::event::detection::sampled_step::SampledStep;
use crate::numerics::legendre::{POINTS, W, X};
use crate::numerics::root_isolation::{self, Accuracy, Crossing, GuardError, RootStart};
use crate::numerics::zero::roundoff;

/// Rounding of g̈, relative to the natural acceleration.
const ROUNDED: f64 = roundoff(64.0);
/// Where a flight that begins as t³ and lands is highest, as a part of its length.
const HIGHEST: f64 = 2.0 / 3.0;
/// Order of the first derivative of the gap that does not vanish at the lift-off.
const ORDER: usize = 3;

/// g and ġ at the start of a step, integrated since the lift-off.
#[derive(Debug, Clone, Copy)]
pub(super) struct LowFlight {
    gap: f64,
    rate: f64,
}

impl LowFlight {
    /// At a lift-off where the first nonzero derivative is of this order.
    pub(super) fn begin(order: usize) -> Option<Self> {
        (order == ORDER).then_some(Self { gap: 0.0, rate: 0.0 })
    }

    /// Where the contact lands, if it stays low. Its `gap` by itself is seen to close at `end`, at
    /// the start where it is not seen to open.
    pub(super) fn find_landing(
        &self,
        contact: usize,
        step: &SampledStep<'_>,
        (gap, end): (&dyn Fn(f64) -> f64, f64),
    ) -> Result<Option<f64>, GuardError> {
        if self.keeps_rising(contact, step) {
            return Ok(None);
        }
        let (h, natural) = step.view.scales();
        // The gap per θ² h² from the lift-off on, the gap itself later.
        let fresh = self.gap == 0.0;
        let value = |theta: f64| {
            let [_, mean] = means(contact, step, theta);
            if fresh { mean } else { self.gap + theta * h * (self.rate + theta * h * mean) }
        };
        let (start, bound) = match fresh {
            true => (RootStart::Root, ROUNDED * natural),
            false => (RootStart::Free, roundoff(1.0) * self.gap.max(h * h * natural)),
        };
        let accuracy = Accuracy { delta: bound, is_noisy: true };
        let Crossing::At { theta } = root_isolation::watch(value, start, accuracy)? else {
            return Ok(None);
        };
        let is_first = end == 0.0 || end >= HIGHEST * theta;
        Ok((is_first && step.scales.is_low(contact, gap(HIGHEST * theta))).then_some(theta))
    }

    /// Whether g̈ > 0 is proved of all of a step that begins with g ≥ 0 and ġ ≥ 0.
    fn keeps_rising(&self, contact: usize, step: &SampledStep<'_>) -> bool {
        let accuracy = Accuracy { delta: ROUNDED * step.view.scales().1, is_noisy: false };
        let acceleration = |theta: f64| step.gap_acceleration(theta, contact);
        self.gap >= 0.0
            && self.rate >= 0.0
            && root_isolation::watch(acceleration, RootStart::Root, accuracy) == Ok(Crossing::Clear)
    }

    /// The flight at the end of the step.
    pub(super) fn follow(self, contact: usize, step: &SampledStep<'_>) -> Self {
        let (h, _) = step.view.scales();
        let [rate, gap] = means(contact, step, 1.0);
        Self { gap: self.gap + h * (self.rate + h * gap), rate: self.rate + h * rate }
    }
}

/// ∫₀¹ g̈(θ σ) dσ and ∫₀¹ (1 − σ) g̈(θ σ) dσ.
fn means(contact: usize, step: &SampledStep<'_>, theta: f64) -> [f64; 2] {
    (0..POINTS).fold([0.0; 2], |[rate, gap], k| {
        let sigma = 0.5 * (1.0 + X[k]);
        let part = 0.5 * W[k] * step.gap_acceleration(theta * sigma, contact);
        [rate + part, gap + (1.0 - sigma) * part]
    })
}
