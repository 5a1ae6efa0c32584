//! What a pair is: its stages, its error estimate, its dense output.

use crate::integrate::Tolerance;
use crate::integrate::combination::{Weight, advance, combine};
use crate::scalar::Scalar;

/// A pair with `L` slopes: its stages, then f at the end of the step.
pub trait Pair<const L: usize> {
    /// aᵢⱼ of the stages kᵢ = f(y + h Σ aᵢⱼ kⱼ), i = 2, …; zeros are left out.
    const A: &'static [&'static [Weight]];
    /// bᵢ of the step y₁ = y + h Σ bᵢ kᵢ.
    const B: &'static [Weight];
    /// The error estimate is O(hᵖ) with this p.
    const ORDER: f64;
    /// The largest |e^z − R(z)|/zᵖ⁺¹ for 0 < z ≤ 1, with y₁ = R(h λ) y₀ for y′ = λ y.
    const ERROR_CONSTANT: f64;
    /// Whether the error estimate takes f at the end of the step.
    const ERROR_HAS_END: bool;
    /// Coefficients of the dense output.
    const TERMS: usize;
    /// Evaluations of f that the dense output takes.
    const DENSE_EVALUATIONS: u64;

    /// The step of length h from y, where f is `slope`.
    fn trial<S: Scalar, const N: usize>(
        f: &impl Fn(&[S; N]) -> [S; N],
        y: &[S; N],
        slope: [S; N],
        h: S,
    ) -> Trial<S, N, L> {
        let mut k = [slope; L];
        for (i, row) in Self::A.iter().enumerate() {
            k[i + 1] = f(&advance(y, h, &combine(&k, row)));
        }
        Trial { y1: advance(y, h, &combine(&k, Self::B)), slopes: k }
    }

    /// The error of the step from `y0` in units of the tolerance.
    fn error<S: Scalar, const N: usize>(
        trial: &Trial<S, N, L>,
        tolerance: &Tolerance<N>,
        y0: &[S; N],
        h: S,
    ) -> f64;

    /// Coefficients of the step from `y0` for θ and 1 − θ in turn.
    fn dense<S: Scalar, const N: usize>(
        f: &impl Fn(&[S; N]) -> [S; N],
        h: S,
        y0: &[S; N],
        step: &Trial<S, N, L>,
    ) -> impl IntoIterator<Item = [S; N]>;
}

/// A step not yet accepted: its end, and its slopes, of which the last, f(y₁), is not yet known.
pub struct Trial<S, const N: usize, const L: usize> {
    pub(in crate::integrate) y1: [S; N],
    pub(in crate::integrate) slopes: [[S; N]; L],
}
