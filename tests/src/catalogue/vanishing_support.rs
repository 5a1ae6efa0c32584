//! Entry 4: a level rod on two supports at distance d from its centre, one of which vanishes.

/// Reaction of the other, in mg, at once: 1/(1 + 12 d²/L²).
pub fn reaction(offset: f64, length: f64) -> f64 {
    1.0 / (1.0 + 12.0 * (offset / length).powi(2))
}
