//! Entries 5 and 7: a bar hinged at one end, θ below the level, released level.

use crate::numerics::elliptic_k;

/// θ̇² = 3 sin θ.
pub fn rate_squared(theta: f64) -> f64 {
    3.0 * theta.sin()
}

/// θ̈ = (3/2) cos θ.
pub fn acceleration(theta: f64) -> f64 {
    1.5 * theta.cos()
}

/// Hinge force along the bar, towards the hinge: (5/2) sin θ.
pub fn force_along(theta: f64) -> f64 {
    2.5 * theta.sin()
}

/// Hinge force across the bar, against the weight: ¼ cos θ.
pub fn force_across(theta: f64) -> f64 {
    0.25 * theta.cos()
}

/// Period of amplitude α from the hanging rest: 4√(2/3) K(sin²(α/2)).
pub fn period(amplitude: f64) -> f64 {
    4.0 * (2.0_f64 / 3.0).sqrt() * elliptic_k((0.5 * amplitude).sin().powi(2))
}
