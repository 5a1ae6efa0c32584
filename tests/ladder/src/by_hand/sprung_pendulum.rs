//! The pendulum with a spring, k = 20, s = ½.

use crate::GRAVITY;

/// Rates of φ and of its rate, B at (sin φ, −cos φ) and r its distance from E = (1, 0), r² = 2 − 2
/// sin φ: ⅓ φ̈ = −½ g sin φ + k (1 − s/r) cos φ.
pub fn rates(&[phi, w]: &[f64; 2]) -> [f64; 2] {
    let (sin, cos) = phi.sin_cos();
    let pull = 20.0 * (1.0 - 0.5 / (2.0 - 2.0 * sin).sqrt());
    [w, 3.0 * pull * cos - 1.5 * GRAVITY * sin]
}
