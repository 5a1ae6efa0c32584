//! A parallelogram of two cranks and a coupler, m = l = c = 1: the coupler stays level.

use crate::GRAVITY;

/// Rates of φ and of its rate: l (⅔ m + c) φ̈ = −(m + c) g sin φ.
pub fn rates(&[phi, w]: &[f64; 2]) -> [f64; 2] {
    [w, -1.2 * GRAVITY * phi.sin()]
}
