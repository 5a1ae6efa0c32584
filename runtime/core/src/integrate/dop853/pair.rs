//! The error estimate h e₅² / √(e₅² + 0.01 e₃²) (Hairer, Nørsett, Wanner I, II.10, eq. 10.17).

use super::coefficients::{A, B, ERROR5, THIRD};
use super::{DormandPrince, SLOPES, dense};
use crate::integrate::Tolerance;
use crate::integrate::combination::{Weight, combine};
use crate::integrate::explicit::{Pair, Trial};
use crate::integrate::tolerance::norm;
#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use crate::scalar::Scalar;

impl Pair<SLOPES> for DormandPrince {
    const A: &'static [&'static [Weight]] = &A;
    const B: &'static [Weight] = B;
    const ORDER: f64 = 8.0;
    const ERROR_CONSTANT: f64 = 1.175e-7;
    const ERROR_HAS_END: bool = false;
    const TERMS: usize = 8;
    const DENSE_EVALUATIONS: u64 = 3;

    /// The error in units of the tolerance.
    fn error<S: Scalar, const N: usize>(
        trial: &Trial<S, N, SLOPES>,
        tolerance: &Tolerance<N>,
        y0: &[S; N],
        h: S,
    ) -> f64 {
        let k = &trial.slopes;
        let scale = tolerance.scale(y0, &trial.y1);
        let (eighth, third) = (combine(k, B), combine(k, THIRD));
        let e3 = norm(&core::array::from_fn(|i| eighth[i] - third[i]), &scale);
        let e5 = norm(&combine(k, ERROR5), &scale);
        let total = e5.hypot(0.1 * e3);
        if total == 0.0 { 0.0 } else { h.to_f64() * e5 * (e5 / total) }
    }

    fn dense<S: Scalar, const N: usize>(
        f: &impl Fn(&[S; N]) -> [S; N],
        h: S,
        y0: &[S; N],
        step: &Trial<S, N, SLOPES>,
    ) -> impl IntoIterator<Item = [S; N]> {
        dense::coefficients(f, h, y0, step)
    }
}
