//! Legendre polynomials and their zeros.

#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use crate::scalar::{DoubleDouble, Real, Scalar};

/// Stages of a step; its order is twice that.
pub(super) const STAGES: usize = 6;

/// Stages of the dense output, whose order is that of a step.
pub(super) const FINE: usize = 2 * STAGES;

/// P₀ … P₁₂ at one place.
pub(super) type LegendreValues = [DoubleDouble; FINE + 1];

/// P₀(x) … P₁₂(x): (k + 1) Pₖ₊₁ = (2k + 1) x Pₖ − k Pₖ₋₁.
pub(super) fn values(x: DoubleDouble) -> LegendreValues {
    let mut p = [DoubleDouble::ratio(1, 1); FINE + 1];
    p[1] = x;
    for k in 1..FINE {
        p[k + 1] = next(k, x * p[k], p[k - 1]);
    }
    p
}

/// Pₖ₊₁ from x Pₖ and Pₖ₋₁.
pub(super) fn next(k: usize, turned: DoubleDouble, before: DoubleDouble) -> DoubleDouble {
    let n = k as i64;
    (DoubleDouble::ratio(2 * n + 1, 1) * turned - DoubleDouble::ratio(n, 1) * before)
        / DoubleDouble::ratio(n + 1, 1)
}

/// The zeros of P_s and the weights on [0, 1], bᵢ = 1/((1 − xᵢ²) P_s′(xᵢ)²) (Abramowitz & Stegun
/// 25.4.29).
pub(super) fn nodes<const S: usize>() -> [(DoubleDouble, DoubleDouble); S] {
    let one = DoubleDouble::ratio(1, 1);
    let slope = |x: DoubleDouble, p: &LegendreValues| {
        DoubleDouble::ratio(S as i64, 1) * (p[S - 1] - x * p[S]) / (one - x * x)
    };
    core::array::from_fn(|i| {
        let angle = core::f64::consts::PI * (i as f64 + 0.75) / (S as f64 + 0.5);
        // Newton's method doubles the digits of a start with two.
        let x = (0..6).fold(DoubleDouble::from_f64(-angle.cos()), |x, _| {
            let p = values(x);
            x - p[S] / slope(x, &p)
        });
        let rate = slope(x, &values(x));
        (x, one / ((one - x * x) * rate * rate))
    })
}

/// The nearest double.
pub(super) fn round(x: DoubleDouble) -> f64 {
    x.to_f64()
}
