//! Step control by error per step with Gustafsson's PI term: h ← h · 0.9 err⁻ᵅ err₋₁ᵝ, α = 1/p −
//! β/5 (Hairer, Nørsett, Wanner I, II.4; Hairer & Wanner II, IV.2).

#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;

/// Safety and limits of the factor, those of DOP853 by Hairer, Nørsett, Wanner.
const SAFETY: f64 = 0.9;
const SMALLEST: f64 = 1.0 / 3.0;
const LARGEST: f64 = 6.0;
/// Errors below this do not hold the next step back.
const LEAST_MEMORY: f64 = 1e-4;

/// Chooses the factor from one step to the next; `err` ≤ 1 means accepted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Controller {
    alpha: f64,
    beta: f64,
    previous: f64,
    rejected: bool,
}

impl Controller {
    /// For a method whose error estimate is of order `p` in the step.
    pub(super) fn new(order: f64, beta: f64) -> Self {
        Self { alpha: 1.0 / order - 0.2 * beta, beta, previous: LEAST_MEMORY, rejected: false }
    }

    /// The factor after an accepted step; no growth straight after a rejection.
    pub(super) fn accepted(&mut self, err: f64) -> f64 {
        let wanted = SAFETY * self.previous.powf(self.beta) / err.powf(self.alpha);
        let largest = if self.rejected { 1.0 } else { LARGEST };
        self.previous = err.max(LEAST_MEMORY);
        self.rejected = false;
        wanted.clamp(SMALLEST, largest)
    }

    /// The factor before the next trial.
    pub(super) fn rejected(&mut self, err: f64) -> f64 {
        self.rejected = true;
        if err.is_finite() { (SAFETY / err.powf(self.alpha)).clamp(SMALLEST, SAFETY) } else { SMALLEST }
    }
}
