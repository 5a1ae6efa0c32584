//! Entry 10: two bars hinged at the apex, feet on a smooth floor, φ to the floor, at rest at φ₀ (s =
//! sin φ).

use super::ladder::{sine_fall, time_from_rest};

/// φ̇² = 3(s₀ − s).
pub fn rate_squared(start: f64, phi: f64) -> f64 {
    3.0 * sine_fall(start, start - phi)
}

/// Reaction of one foot: ¼ − (3/2) s s₀ + (9/4) s².
pub fn reaction(start: f64, phi: f64) -> f64 {
    let (s0, s) = (start.sin(), phi.sin());
    0.25 - 1.5 * s * s0 + 2.25 * s * s
}

/// Its least value (1 − s₀²)/4, at s = s₀/3.
pub fn least_reaction(start: f64) -> f64 {
    0.25 * start.cos().powi(2)
}

/// Speed of the apex at the floor, √(3 s₀).
pub fn landing_speed(start: f64) -> f64 {
    (3.0 * start.sin()).sqrt()
}

/// Time from rest to φ.
pub fn time(start: f64, phi: f64) -> f64 {
    time_from_rest(start, phi)
}
