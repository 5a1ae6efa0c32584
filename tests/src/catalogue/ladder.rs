//! Entry 1: a ladder on a smooth floor and wall, θ from the floor, at rest at θ₀ (s = sin θ).
//!
//! Against the wall the centre moves on a circle of radius ½ about the corner: θ̇² = 3(s₀ − s),
//! N_wall = −ẍ, N_floor = 1 + ÿ. It leaves at s = ⅔ s₀ and slides on with v_x = s₀^{3/2}/3.

use crate::numerics::integral;

/// sin a − sin(a − d) as a product, so that it keeps its digits where d is small.
pub(super) fn sine_fall(a: f64, d: f64) -> f64 {
    2.0 * (a - 0.5 * d).cos() * (0.5 * d).sin()
}

/// Time from rest at `start` to θ where θ̇² = 3(s₀ − s); θ = θ₀ − u² lifts the singularity of 1/θ̇
/// at the start.
pub(super) fn time_from_rest(start: f64, theta: f64) -> f64 {
    let slow = |u: f64| 2.0 * u / (3.0 * sine_fall(start, u * u)).sqrt();
    integral(slow, 0.0, (start - theta).sqrt())
}

/// θ̇² against floor and wall.
pub fn rate_squared(start: f64, theta: f64) -> f64 {
    3.0 * sine_fall(start, start - theta)
}

/// θ̈ against floor and wall, −(3/2) cos θ.
pub fn acceleration(theta: f64) -> f64 {
    -1.5 * theta.cos()
}

/// Reaction of the wall, ¾ cos θ (3s − 2s₀).
pub fn wall_reaction(start: f64, theta: f64) -> f64 {
    0.75 * theta.cos() * (3.0 * theta.sin() - 2.0 * start.sin())
}

/// Reaction of the floor, 1 + ½(θ̈ cos θ − θ̇² sin θ); ¼ where the wall is left.
pub fn floor_reaction(start: f64, theta: f64) -> f64 {
    1.0 + 0.5 * (acceleration(theta) * theta.cos() - rate_squared(start, theta) * theta.sin())
}

/// Angle at which the wall is left.
pub fn leaving_angle(start: f64) -> f64 {
    (2.0 / 3.0 * start.sin()).asin()
}

/// Time from rest to θ against the wall.
pub fn time(start: f64, theta: f64) -> f64 {
    time_from_rest(start, theta)
}

/// Velocity of the centre along the floor once the wall is left.
pub fn drift(start: f64) -> f64 {
    start.sin().powf(1.5) / 3.0
}

/// θ̇² off the wall: 12[(s₀ − s) − s₀³/9]/(1 + 3 cos²θ).
pub fn free_rate_squared(start: f64, theta: f64) -> f64 {
    let head = sine_fall(start, start - theta) - start.sin().powi(3) / 9.0;
    12.0 * head / (1.0 + 3.0 * theta.cos().powi(2))
}

/// Reaction of the floor off the wall: (1 − ½θ̇² s)/(1 + 3 cos²θ).
pub fn free_floor_reaction(start: f64, theta: f64) -> f64 {
    let lift = 0.5 * free_rate_squared(start, theta) * theta.sin();
    (1.0 - lift) / (1.0 + 3.0 * theta.cos().powi(2))
}

/// Time from leaving the wall to θ.
pub fn free_time(start: f64, theta: f64) -> f64 {
    let slow = |angle: f64| 1.0 / free_rate_squared(start, angle).sqrt();
    integral(slow, theta, leaving_angle(start))
}
