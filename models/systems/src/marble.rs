use liftoff::prelude::*;

/// A marble slides off a smooth ball.
///
/// ```text
///        P
///     ╭─────╮
///    ╱   r   ╲
///   │    +    │
/// ```
///
/// From rest at the top it leaves two thirds of the radius above the centre.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = circle((0, 0), r))]
#[figure(P = (3 * r / 5, 4 * r / 5))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
pub struct Marble {
    /// Mass.
    pub m: f64,
    /// Radius.
    pub r: f64,
    /// Gravity.
    pub g: f64,
}
