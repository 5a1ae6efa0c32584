//! Dense output of order 7 (Hairer, Nørsett, Wanner I, II.6, eq. 6.30 ff.):
//! y(t₀ + θh) = y₀ + θ(F₀ + θ̄(F₁ + θ(F₂ + θ̄(F₃ + θ(F₄ + θ̄(F₅ + θF₆)))))), θ̄ = 1 − θ.

use super::SLOPES;
use super::coefficients::{A_DENSE, D};
use crate::integrate::combination::{advance, combine};
use crate::integrate::dense::hermite;
use crate::integrate::explicit::Trial;
use crate::scalar::Scalar;

/// y₀, F₀ … F₆ of the step from `y0`.
pub(super) fn coefficients<S: Scalar, const N: usize>(
    f: &impl Fn(&[S; N]) -> [S; N],
    h: S,
    y0: &[S; N],
    step: &Trial<S, N, SLOPES>,
) -> [[S; N]; 8] {
    let mut k = [step.slopes[0]; SLOPES + 3];
    k[..SLOPES].copy_from_slice(&step.slopes);
    for (i, row) in A_DENSE.iter().enumerate() {
        k[SLOPES + i] = f(&advance(y0, h, &combine(&k, row)));
    }
    let [c0, c1, c2, c3] = hermite(h, [*y0, step.y1], [k[0], k[SLOPES - 1]]);
    let [c4, c5, c6, c7] = D.map(|row| combine(&k, row).map(|sum| h * sum));
    [c0, c1, c2, c3, c4, c5, c6, c7]
}
