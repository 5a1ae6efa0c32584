//! Fig. 1b at rest on its thread, all bars at φ to the floor: statics of DE and CD, floor smooth.

/// Tension ½(m₁ + m₂) g cot φ.
pub fn tension(inner: f64, outer: f64, gravity: f64, phi: f64) -> f64 {
    0.5 * (inner + outer) * gravity / phi.tan()
}

/// Reactions at A (or E), m₂g/2, and at C, (2m₁ + m₂) g.
pub fn reactions(inner: f64, outer: f64, gravity: f64) -> [f64; 2] {
    [0.5 * outer * gravity, (2.0 * inner + outer) * gravity]
}
