use liftoff::prelude::*;

/// A rod topples from the upright on a floor with dry friction, until its foot slips.
///
/// ```text
///        ╱ B
///     │φ╱
///     │╱
///   ▔▔A▔▔▔▔▔▔       φ from the vertical
/// ```
///
/// From rest upright N = ¼ mg (1 − 3 cos φ)² and R = ¾ mg sin φ (3 cos φ − 2): for μ < 15√40/256 the foot slips backward, else
/// forward, beyond 48.19°.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[figure(A = (0, 0), B = (3 * l / 5, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = vertical)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct SlippingRod {
    /// Mass of the rod.
    pub m: f64,
    /// Length of the rod.
    pub l: f64,
    /// Friction of the floor.
    pub mu: f64,
    /// Gravity.
    pub g: f64,
}
