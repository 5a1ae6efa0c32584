//! Step control with Gustafsson's prediction (Hairer & Wanner II, IV.8, eqs. 8.21, 8.25, 8.26).

use super::newton::Newton;

/// Safety and limits of the factor, those of RADAU5 by Hairer and Wanner.
const SAFETY: f64 = 0.9;
const SMALLEST: f64 = 0.2;
const LARGEST: f64 = 8.0;
/// Errors below this do not hold the next step back.
const LEAST_MEMORY: f64 = 1e-2;
/// A step that would grow by less is kept, and with it the factored matrices.
const WORTHWHILE: f64 = 1.2;

/// The step before, as far as it predicts.
pub(super) struct Control {
    accepted: Option<(f64, f64)>,
    pub(super) rejected: bool,
}

impl Control {
    pub(super) const NEW: Self = Self { accepted: None, rejected: false };

    /// Whether the step before was rejected or there was none: its error estimate is then checked.
    pub(super) fn is_wary(&self) -> bool {
        self.rejected || self.accepted.is_none()
    }

    /// The step after one of length `h` with this error was accepted.
    pub(super) fn accept(&mut self, h: f64, err: f64, iterations: i32) -> f64 {
        let mut factor = Self::factor(err, iterations);
        if let Some((before, memory)) = self.accepted {
            let trend = SAFETY * (h / before) * (memory / (err * err)).powf(0.25);
            factor = factor.min(trend.clamp(SMALLEST, LARGEST));
        }
        if core::mem::take(&mut self.rejected) {
            factor = factor.min(1.0);
        }
        self.accepted = Some((h, err.max(LEAST_MEMORY)));
        if (1.0..=WORTHWHILE).contains(&factor) { h } else { h * factor }
    }

    /// The step to try after one of length `h` was rejected for its error.
    pub(super) fn reject(&mut self, h: f64, err: f64, iterations: i32) -> f64 {
        self.rejected = true;
        h * if self.accepted.is_none() { 0.1 } else { Self::factor(err, iterations).min(SAFETY) }
    }

    fn factor(err: f64, iterations: i32) -> f64 {
        let most = f64::from(2 * Newton::MOST);
        let safety = SAFETY.min(SAFETY * (most + 1.0) / (most + f64::from(iterations)));
        (safety / err.powf(0.25)).clamp(SMALLEST, LARGEST)
    }
}
