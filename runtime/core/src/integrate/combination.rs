//! Linear combinations of slopes, as the tableau of a Runge–Kutta method has them.

use crate::scalar::Scalar;

/// One linear combination of slopes: (stage counted from 0, coefficient).
pub(super) type StageWeights<const M: usize> = [(usize, f64); M];

/// Σ aⱼ kⱼ.
#[inline]
pub(super) fn combine<S: Scalar, const N: usize, const L: usize, const M: usize>(
    k: &[[S; N]; L],
    row: &StageWeights<M>,
) -> [S; N] {
    core::array::from_fn(|i| {
        let (first, a) = row[0];
        row[1..]
            .iter()
            .fold(S::from_f64(a) * k[first][i], |sum, &(stage, a)| S::from_f64(a).mul_add(k[stage][i], sum))
    })
}

/// y + h k.
#[inline]
pub(super) fn advance<S: Scalar, const N: usize>(y: &[S; N], h: S, k: &[S; N]) -> [S; N] {
    core::array::from_fn(|i| h.mul_add(k[i], y[i]))
}
