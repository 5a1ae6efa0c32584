//! Linear combinations of slopes, as the tableau of a Runge–Kutta method has them.

use crate::scalar::Scalar;

/// A stage, counted from 0, and its coefficient.
pub type Weight = (usize, f64);

/// Σ aⱼ kⱼ over the stages of a row, which is not empty.
#[inline]
pub(super) fn combine<S: Scalar, const N: usize>(k: &[[S; N]], row: &[Weight]) -> [S; N] {
    let (first, a) = row[0];
    let mut sum = k[first].map(|slope| S::from_f64(a) * slope);
    for &(stage, a) in &row[1..] {
        let (a, slope) = (S::from_f64(a), &k[stage]);
        for i in 0..N {
            sum[i] = a.mul_add(slope[i], sum[i]);
        }
    }
    sum
}

/// y + h k.
#[inline]
pub(super) fn advance<S: Scalar, const N: usize>(y: &[S; N], h: S, k: &[S; N]) -> [S; N] {
    core::array::from_fn(|i| h.mul_add(k[i], y[i]))
}
