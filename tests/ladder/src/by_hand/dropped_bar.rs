//! A bar that falls on a smooth floor and rebounds, m = l = 1, e = ½.

use crate::GRAVITY;

/// Rates of φ, x, y, and their rates.
pub fn rates(&[_, _, _, w, u, v]: &[f64; 6]) -> [f64; 6] {
    [w, u, v, 0.0, 0.0, -GRAVITY]
}

/// The height of A.
pub fn gap(&[phi, _, y, ..]: &[f64; 6]) -> f64 {
    y - 0.5 * phi.sin()
}

/// What an impact at A leaves, Newton's law: P (1/m + (½ cos φ)²/J) = −(1 + e) ġ, J = 1/12.
pub fn impact(&[phi, x, y, w, u, v]: &[f64; 6]) -> [f64; 6] {
    let arm = -0.5 * phi.cos();
    let impulse = -1.5 * (v + arm * w) / (1.0 + 12.0 * arm * arm);
    [phi, x, y, w + 12.0 * arm * impulse, u, v + impulse]
}
