//! Internal forces of a uniform bar that falls about its foot, θ from the vertical, at the part ξ
//! of its length: balance of the part beyond the section, with θ̈ = (3/2) sin θ.

/// Tension: ½(1 − ξ²) θ̇² − (1 − ξ) cos θ.
pub fn tension(theta: f64, rate: f64, part: f64) -> f64 {
    0.5 * (1.0 - part * part) * rate * rate - (1.0 - part) * theta.cos()
}

/// Force on the part beyond, across the bar against the fall: ¼ sin θ (1 − ξ)(1 − 3ξ).
pub fn shear(theta: f64, part: f64) -> f64 {
    0.25 * theta.sin() * (1.0 - part) * (1.0 - 3.0 * part)
}

/// Moment on the part beyond, in the sense of the fall: ¼ sin θ ξ(1 − ξ)², largest at ξ = ⅓.
pub fn moment(theta: f64, part: f64) -> f64 {
    0.25 * theta.sin() * part * (1.0 - part).powi(2)
}
