//! Entry 8: a point bounces with restitution e from the height h.

/// When it rests: √(2h/g) (1 + 2e + 2e² + …) = √(2h/g) (1 + e)/(1 − e).
pub fn rest(e: f64, height: f64, gravity: f64) -> f64 {
    (2.0 * height / gravity).sqrt() * (1.0 + e) / (1.0 - e)
}
