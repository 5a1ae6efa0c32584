//! A bar that swings about its end, m = l = 1.

use crate::GRAVITY;

/// Rates of φ and of its rate: ⅓ l φ̈ = −½ g sin φ, l = 1.
pub fn rates(&[phi, w]: &[f64; 2]) -> [f64; 2] {
    [w, -1.5 * GRAVITY * phi.sin()]
}
