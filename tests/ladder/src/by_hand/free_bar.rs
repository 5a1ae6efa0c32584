//! A bar in free motion, m = l = 1.

/// Rates of φ, x, y, and their rates.
pub fn rates(&[_, _, _, w, u, v]: &[f64; 6]) -> [f64; 6] {
    [w, u, v, 0.0, 0.0, 0.0]
}
