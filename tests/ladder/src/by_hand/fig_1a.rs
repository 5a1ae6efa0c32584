//! The paper's Fig. 1a, m = l = 1: the symmetric half that its author computes.

use crate::GRAVITY;

/// Rates of φ and of its rate on the corners: T = A φ̇², A = ¼ (4/3 + sec⁴ φ − 2 sec φ), V = −g
/// (tan φ − sin φ).
pub fn held(&[phi, w]: &[f64; 2]) -> [f64; 2] {
    let (tan, sec) = (phi.tan(), 1.0 / phi.cos());
    let mass = 0.5 * (4.0 / 3.0 + sec.powi(4) - 2.0 * sec);
    let slope = tan * sec * (sec.powi(3) - 0.5);
    [w, (GRAVITY * (sec * sec - 1.0 / sec) - slope * w * w) / mass]
}

/// N of a corner: (g − ÿ)/cos φ, y = ½ (tan φ − sin φ) the drop of a bar's centre.
pub fn reaction(state: &[f64; 2]) -> f64 {
    let [phi, w] = *state;
    let (tan, sec) = (phi.tan(), 1.0 / phi.cos());
    let drop = (sec * sec - 1.0 / sec) * held(state)[1] + (2.0 * sec * sec * tan + phi.sin()) * w * w;
    (GRAVITY - 0.5 * drop) * sec
}

/// Rates of φ, the drop y of D, and their rates in free flight.
pub fn free(&[phi, _, w, v]: &[f64; 4]) -> [f64; 4] {
    let (s, c) = phi.sin_cos();
    let turn = -0.5 * w * w * s * c / (2.0 / 3.0 - 0.5 * c * c);
    [w, v, turn, GRAVITY + 0.5 * (turn * c - w * w * s)]
}

/// What a bar is above its corner, at the corner: ½ sin φ − y cos φ.
pub fn gap(&[phi, y, ..]: &[f64; 4]) -> f64 {
    0.5 * phi.sin() - y * phi.cos()
}
