//! A bar whose foot slides on a smooth floor, m = l = 1.

use crate::GRAVITY;

/// Rates of φ, x on the floor, y = ½ sin φ, and of their rates: (1/12 + ¼ cos² φ) φ̈ = ¼ φ̇² sin φ
/// cos φ − ½ g cos φ.
pub fn rates(&[phi, _, w, u]: &[f64; 4]) -> [f64; 4] {
    let (s, c) = phi.sin_cos();
    [w, u, c * (0.25 * w * w * s - 0.5 * GRAVITY) / (1.0 / 12.0 + 0.25 * c * c), 0.0]
}

/// N/m = g + ÿ = g + ½ (φ̈ cos φ − φ̇² sin φ).
pub fn reaction(state: &[f64; 4]) -> f64 {
    let (s, c) = state[0].sin_cos();
    let [_, _, spin, _] = rates(state);
    GRAVITY + 0.5 * (spin * c - state[2] * state[2] * s)
}
