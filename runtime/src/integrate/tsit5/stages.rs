//! The stages kᵢ = f(y + h Σ aᵢⱼ kⱼ), the step y₁ = y + h Σ bᵢ kᵢ with k₇ = f(y₁), and its error estimate h Σ eᵢ kᵢ.

use super::coefficients::{A2, A3, A4, A5, A6, B, ERROR, QUARTIC};
use crate::integrate::combination::{advance, combine};
use crate::integrate::tolerance::norm;
use crate::integrate::{Rates, Tolerance};
use crate::scalar::Scalar;

/// Index of f(y₁) among the slopes.
pub(super) const LAST: usize = 6;

/// k₁ … k₇.
pub(super) type Slopes<S, const N: usize> = [[S; N]; LAST + 1];

/// A step not yet accepted.
pub(super) struct Trial<S, const N: usize> {
    pub(super) y1: [S; N],
    pub(super) slopes: Slopes<S, N>,
}

impl<S: Scalar, const N: usize> Trial<S, N> {
    /// Evaluations of f, that at the start left out.
    pub(super) const EVALUATIONS: u64 = 6;

    pub(super) fn new(f: Rates<S, N>, y: &[S; N], slope: [S; N], h: S) -> Self {
        let mut k = [slope; LAST + 1];
        k[1] = f(&advance(y, h, &combine(&k, &A2)));
        k[2] = f(&advance(y, h, &combine(&k, &A3)));
        k[3] = f(&advance(y, h, &combine(&k, &A4)));
        k[4] = f(&advance(y, h, &combine(&k, &A5)));
        k[5] = f(&advance(y, h, &combine(&k, &A6)));
        let y1 = advance(y, h, &combine(&k, &B));
        k[LAST] = f(&y1);
        Self { y1, slopes: k }
    }

    /// The error in units of the tolerance.
    pub(super) fn error(&self, tolerance: &Tolerance<N>, y0: &[S; N], h: S) -> f64 {
        let scale = tolerance.scale(y0, &self.y1);
        h.to_f64() * norm(&combine(&self.slopes, &ERROR), &scale)
    }
}

/// What the dense output has beyond Hermite's cubic, divided by h: the coefficient of θ²(1 − θ)², which is that of θ⁴.
pub(super) fn quartic<S: Scalar, const N: usize>(slopes: &Slopes<S, N>) -> [S; N] {
    combine(slopes, &QUARTIC)
}
