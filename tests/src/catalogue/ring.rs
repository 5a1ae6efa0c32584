//! A particle outside or inside a smooth upright circle of radius 1.

use crate::numerics::integral;

/// Outside, from rest at the top, θ from the top: N = 3 cos θ − 2, zero where it leaves.
pub fn outer_reaction(theta: f64) -> f64 {
    3.0 * theta.cos() - 2.0
}

/// Time between two angles outside, θ̇ = 2 sin ½θ.
pub fn outer_time(from: f64, to: f64) -> f64 {
    ((0.25 * to).tan() / (0.25 * from).tan()).ln()
}

/// Inside, at v below, θ from below: θ̇² = v² − 2(1 − cos θ).
pub fn inner_rate_squared(speed: f64, theta: f64) -> f64 {
    speed * speed - 4.0 * (0.5 * theta).sin().powi(2)
}

/// Inside: N = v² − 2 + 3 cos θ.
pub fn inner_reaction(speed: f64, theta: f64) -> f64 {
    speed * speed - 2.0 + 3.0 * theta.cos()
}

/// Where the track is left inside, if it is: cos θ = (2 − v²)/3, for 2 < v² < 5.
pub fn leaving_angle(speed: f64) -> Option<f64> {
    let cos = (2.0 - speed * speed) / 3.0;
    (cos > -1.0 && cos < 0.0).then(|| cos.acos())
}

/// Time from below to θ inside.
pub fn inner_time(speed: f64, theta: f64) -> f64 {
    integral(|angle| 1.0 / inner_rate_squared(speed, angle).sqrt(), 0.0, theta)
}
