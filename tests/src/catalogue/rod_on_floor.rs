//! Entry 2: a rod on a smooth floor, θ from the vertical, at rest at θ = a.

use crate::numerics::integral;

/// cos a − cos θ as a product.
fn drop(start: f64, theta: f64) -> f64 {
    2.0 * (0.5 * (theta + start)).sin() * (0.5 * (theta - start)).sin()
}

/// θ̇² = 12(cos a − cos θ)/(1 + 3 sin²θ).
pub fn rate_squared(start: f64, theta: f64) -> f64 {
    12.0 * drop(start, theta) / (1.0 + 3.0 * theta.sin().powi(2))
}

/// θ̈ = sin θ (6 − 3 θ̇² cos θ)/(1 + 3 sin²θ), half the derivative of θ̇².
pub fn acceleration(start: f64, theta: f64) -> f64 {
    let (sin, cos) = theta.sin_cos();
    sin * (6.0 - 3.0 * rate_squared(start, theta) * cos) / (1.0 + 3.0 * sin * sin)
}

/// N = 1 + ÿ, y = ½ cos θ.
pub fn reaction(start: f64, theta: f64) -> f64 {
    let (sin, cos) = theta.sin_cos();
    1.0 - 0.5 * (rate_squared(start, theta) * cos + acceleration(start, theta) * sin)
}

/// Time from rest to θ: the start lies in a slow, nearly exponential stretch, so θ = a cosh u (√6 u
/// is time to first order in θ) makes the integrand smooth from the start on.
pub fn time(start: f64, theta: f64) -> f64 {
    let slow = |u: f64| {
        let angle = start * u.cosh();
        let rise = 2.0 * start * (0.5 * u).sinh().powi(2);
        let head = 24.0 * (0.5 * (angle + start)).sin() * (0.5 * rise).sin();
        start * u.sinh() * ((1.0 + 3.0 * angle.sin().powi(2)) / head).sqrt()
    };
    integral(slow, 0.0, (theta / start).acosh())
}
