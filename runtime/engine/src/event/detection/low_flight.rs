//! Flights of contacts that lift off with their reaction at zero and come back before they are much higher than the rounding of
//! their gap.
//!
//! The gap is lost in rounding there, its acceleration is not: it is as large as the reaction would be. With g = ġ = 0 at the
//! lift-off,
//!
//! ```text
//! g(θ) = g₀ + ġ₀ h θ + h² θ² ∫₀¹ (1 − σ) g̈(θ σ) dσ
//! ```
//!
//! by Gauss's points. Where g̈ stays above zero there is no landing to look for.

use super::watch::LowFlight;
use super::{EventDetector, StepView, Watch};
use crate::numerics::legendre::{POINTS, W, X};
use crate::numerics::root_isolation::{self, Accuracy, Crossing, GuardError, Start};

/// Rounding of g̈, relative to the natural acceleration.
const ROUNDED: f64 = 64.0 * f64::EPSILON;
/// A gap so much larger than its rounding, in natural lengths, is seen well enough by itself: √ε.
const SEEN: f64 = 1e-8;
/// Where a flight that begins as t³ and lands is highest, as a part of its length.
const HIGHEST: f64 = 2.0 / 3.0;

impl EventDetector<'_> {
    /// Where a contact that has lifted off lands, if it stays low. Its gap by itself is seen to close at `end`, at the start where it
    /// is not seen to open.
    pub(super) fn landing(
        &self,
        watch: &Watch,
        contact: usize,
        step: &StepView<'_>,
        end: f64,
    ) -> Result<Option<f64>, GuardError> {
        let Some(flight) = watch.flight else { return Ok(None) };
        if self.keeps_rising(&flight, contact, step) {
            return Ok(None);
        }
        let (h, natural) = step.scales();
        // The gap per θ² h² from the lift-off on, the gap itself later.
        let fresh = flight.gap == 0.0;
        let value = |theta: f64| {
            let [_, mean] = self.means(contact, step, theta);
            if fresh { mean } else { flight.gap + theta * h * (flight.rate + theta * h * mean) }
        };
        let (start, bound) = match fresh {
            true => (Start::Root, ROUNDED * natural),
            false => (Start::Free, f64::EPSILON * flight.gap.max(h * h * natural)),
        };
        let accuracy = Accuracy { delta: bound, is_noisy: true };
        let Crossing::At { theta } = root_isolation::watch(value, start, accuracy)? else {
            return Ok(None);
        };
        let is_first = end == 0.0 || end >= HIGHEST * theta;
        Ok((is_first && self.is_low(self.value(step, watch, HIGHEST * theta))).then_some(theta))
    }

    /// Whether g̈ > 0 is proved of all of a step that begins with g ≥ 0 and ġ ≥ 0.
    fn keeps_rising(&self, flight: &LowFlight, contact: usize, step: &StepView<'_>) -> bool {
        let accuracy = Accuracy { delta: ROUNDED * step.scales().1, is_noisy: false };
        let acceleration = |theta: f64| step.gap_acceleration(theta, contact, &mut self.values.borrow_mut());
        flight.gap >= 0.0
            && flight.rate >= 0.0
            && root_isolation::watch(acceleration, Start::Root, accuracy) == Ok(Crossing::Clear)
    }

    /// Whether a gap is so small that its rounding matters, or within its bound.
    pub(super) fn is_low(&self, gap: f64) -> bool {
        gap <= self.bounds.relative.max(SEEN) * self.bounds.length
    }

    /// The flight at the end of the step.
    pub(super) fn follow(&self, flight: LowFlight, contact: usize, step: &StepView<'_>) -> LowFlight {
        let (h, _) = step.scales();
        let [rate, gap] = self.means(contact, step, 1.0);
        LowFlight { gap: flight.gap + h * (flight.rate + h * gap), rate: flight.rate + h * rate }
    }

    /// ∫₀¹ g̈(θ σ) dσ and ∫₀¹ (1 − σ) g̈(θ σ) dσ.
    fn means(&self, contact: usize, step: &StepView<'_>, theta: f64) -> [f64; 2] {
        let mut values = self.values.borrow_mut();
        (0..POINTS).fold([0.0; 2], |[rate, gap], k| {
            let sigma = 0.5 * (1.0 + X[k]);
            let part = 0.5 * W[k] * step.gap_acceleration(theta * sigma, contact, &mut values);
            [rate + part, gap + (1.0 - sigma) * part]
        })
    }
}
