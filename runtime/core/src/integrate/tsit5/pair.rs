//! The error estimate h Σ eᵢ kᵢ with k₇ = f(y₁), and the dense output.

use super::coefficients::{A, B, ERROR, QUARTIC};
use super::{SLOPES, Tsitouras};
use crate::integrate::Tolerance;
use crate::integrate::combination::{Weight, combine};
use crate::integrate::dense::hermite;
use crate::integrate::explicit::{Pair, Trial};
use crate::integrate::tolerance::norm;
use crate::scalar::Scalar;

impl Pair<SLOPES> for Tsitouras {
    const A: &'static [&'static [Weight]] = &A;
    const B: &'static [Weight] = B;
    const ORDER: f64 = 5.0;
    const ERROR_CONSTANT: f64 = 1.83e-4;
    const ERROR_HAS_END: bool = true;
    const TERMS: usize = 5;
    const DENSE_EVALUATIONS: u64 = 0;

    /// The error in units of the tolerance.
    fn error<S: Scalar, const N: usize>(
        trial: &Trial<S, N, SLOPES>,
        tolerance: &Tolerance<N>,
        y0: &[S; N],
        h: S,
    ) -> f64 {
        let scale = tolerance.scale(y0, &trial.y1);
        h.to_f64() * norm(&combine(&trial.slopes, ERROR), &scale)
    }

    /// Hermite's cubic, and what goes beyond it: the coefficient of θ²(1 − θ)², which is that of
    /// θ⁴.
    fn dense<S: Scalar, const N: usize>(
        _: &impl Fn(&[S; N]) -> [S; N],
        h: S,
        y0: &[S; N],
        step: &Trial<S, N, SLOPES>,
    ) -> impl IntoIterator<Item = [S; N]> {
        let k = &step.slopes;
        let [c0, c1, c2, c3] = hermite(h, [*y0, step.y1], [k[0], k[SLOPES - 1]]);
        [c0, c1, c2, c3, combine(k, QUARTIC).map(|x| h * x)]
    }
}
