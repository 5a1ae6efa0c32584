//! Legendre polynomials and what collocation at their zeros needs.
//!
//! With xᵢ the zeros of P_s, cᵢ = (1 + xᵢ)/2 and bⱼ the weights, the Lagrange polynomials on [0, 1] are
//! ℓⱼ = bⱼ Σ (2k+1) Pₖ(xⱼ) Pₖ, k < s, and ∫ (2k+1) Pₖ dθ = ½ (Pₖ₊₁ − Pₖ₋₁), P₋₁ = −1.

use crate::scalar::{DoubleDouble, Real, Scalar};

/// Stages; the order is twice that.
pub(super) const STAGES: usize = 6;

/// P₀ … P_s at one place.
pub(super) type Values = [DoubleDouble; STAGES + 1];

/// P₀(x) … P_s(x): (k + 1) Pₖ₊₁ = (2k + 1) x Pₖ − k Pₖ₋₁.
pub(super) fn values(x: DoubleDouble) -> Values {
    let mut p = [DoubleDouble::ratio(1, 1); STAGES + 1];
    p[1] = x;
    for k in 1..STAGES {
        let n = k as i64;
        p[k + 1] =
            DoubleDouble::ratio(2 * n + 1, n + 1) * x * p[k] - DoubleDouble::ratio(n, n + 1) * p[k - 1];
    }
    p
}

/// The zeros of P_s and the weights on [0, 1], bᵢ = 1/((1 − xᵢ²) P_s′(xᵢ)²) (Abramowitz & Stegun 25.4.29).
pub(super) fn nodes() -> [(DoubleDouble, DoubleDouble); STAGES] {
    let one = DoubleDouble::ratio(1, 1);
    core::array::from_fn(|i| {
        let angle = core::f64::consts::PI * (i as f64 + 0.75) / (STAGES as f64 + 0.5);
        let slope = |x: DoubleDouble, p: &Values| {
            DoubleDouble::ratio(STAGES as i64, 1) * (p[STAGES - 1] - x * p[STAGES]) / (one - x * x)
        };
        // Newton's method doubles the digits of a start with three.
        let x = (0..6).fold(DoubleDouble::from_f64(-angle.cos()), |x, _| {
            let p = values(x);
            x - p[STAGES] / slope(x, &p)
        });
        let rate = slope(x, &values(x));
        (x, one / ((one - x * x) * rate * rate))
    })
}

/// The nearest double.
pub(super) fn round(x: DoubleDouble) -> f64 {
    x.to_f64()
}
