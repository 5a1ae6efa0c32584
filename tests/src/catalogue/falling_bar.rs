//! Entry 6: an end of a bar, at θ to a smooth floor and falling at v without spin, strikes with
//! restitution e.

/// Impulse (1 + e) m v/(1 + 3 cos² θ); level, (1 + e) m v/2 at each end.
pub fn impulse(e: f64, mass: f64, speed: f64, theta: f64) -> f64 {
    (1.0 + e) * mass * speed / (1.0 + 3.0 * theta.cos().powi(2))
}

/// φ̇ after the lower end was struck: −6 J cos θ/(m l), φ growing towards the upper end's rise.
pub fn spin(impulse: f64, mass: f64, length: f64, theta: f64) -> f64 {
    -6.0 * impulse * theta.cos() / (mass * length)
}
