//! The collocation polynomial p, of order 3, and its defect at the start, which makes it one of
//! order 4: y′ − p′ vanishes at the nodes up to O(h⁴), so that y(θ) = p(θ) + h K ∫₀^θ (τ − c₁)(τ −
//! c₂)(τ − 1) dτ, −c₁c₂ K = f(y₀) − p′(0). The defect is taken through (I − hJ/γ)⁻¹ as in the error
//! estimate, so that stiff components are left alone.

use super::coefficients::NODES;
use super::newton::Stages;

/// Coefficients of θ and 1 − θ in turn. `defect`: h (I − hJ/γ)⁻¹ (f(y₀) − p′(0)).
pub(super) fn coefficients<const N: usize>(y0: &[f64; N], z: &Stages<N>, defect: &[f64; N]) -> [[f64; N]; 5] {
    let [c1, c2, _] = NODES;
    // (τ − c₁)(τ − c₂)(τ − 1) = τ³ − 9/5 τ² + 9/10 τ − 1/10, whose integral is θ(1 − θ)(−1/10 +
    // 7/20 θ − θ²/4).
    let integral = [-0.1, 0.35, -0.25].map(|a| -10.0 * a);
    let mut terms = [*y0, z[2], [0.0; N], [0.0; N], [0.0; N]];
    for i in 0..N {
        // p = y₀ + θ(z₃ + (1 − θ)(a + b θ)).
        let [at1, at2] = [(c1, z[0][i]), (c2, z[1][i])].map(|(c, z1)| (z1 / c - z[2][i]) / (1.0 - c));
        let b = (at2 - at1) / (c2 - c1);
        let a = at1 - b * c1;
        // a + bθ + cθ² = a + θ((b + c) − c(1 − θ)).
        let [a, b, c] = [a + integral[0] * defect[i], b + integral[1] * defect[i], integral[2] * defect[i]];
        (terms[2][i], terms[3][i], terms[4][i]) = (a, b + c, -c);
    }
    terms
}
