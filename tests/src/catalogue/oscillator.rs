//! A mass on a spring with damping, released at rest: m ẍ + c ẋ + k x = 0.

/// x/x₀ and ẋ/x₀ at a time.
pub fn released(mass: f64, damping: f64, stiffness: f64, t: f64) -> [f64; 2] {
    let decay = 0.5 * damping / mass;
    let square = stiffness / mass - decay * decay;
    // cos and sin(ωt)/ω, or their hyperbolic counterparts beyond critical damping
    let omega = square.abs().sqrt();
    let (c, s) = match square {
        s if s > 0.0 => ((omega * t).cos(), (omega * t).sin() / omega),
        s if s < 0.0 => ((omega * t).cosh(), (omega * t).sinh() / omega),
        _ => (1.0, t),
    };
    let envelope = (-decay * t).exp();
    [envelope * (c + decay * s), -envelope * stiffness / mass * s]
}
