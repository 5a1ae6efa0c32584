use liftoff::prelude::*;

/// A ball, small enough to be a point, bounces until it rests.
///
/// ```text
///       P
///       │ y
///   ▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// Dropped from the height h it rests after (1 + e)/(1 − e) √(2h/g) and infinitely many impacts.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
pub struct BouncingBall {
    /// Mass.
    pub m: f64,
    /// Gravity.
    pub g: f64,
    /// Restitution.
    pub e: f64,
}
