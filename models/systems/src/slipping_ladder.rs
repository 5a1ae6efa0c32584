use liftoff::prelude::*;

/// A bar between a floor and a wall, both with dry friction.
///
/// ```text
///   ▏B
///   ▏ ╲
///   ▏  ╲            μ at the floor, ν at the wall
///   ▏   ╲
///   ▏    ╲  φ to the floor
///   ▏▔▔▔▔▔A▔▔▔▔
/// ```
///
/// It can stay where tan φ ≥ (1 − μ ν)/2μ; there both friction forces are at their limits at once.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[support(B = wall(0), facing = right, friction = nu)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct SlippingLadder {
    /// Mass of the bar.
    pub m: f64,
    /// Length of the bar.
    pub l: f64,
    /// Friction of the floor.
    pub mu: f64,
    /// Friction of the wall.
    pub nu: f64,
    /// Gravity.
    pub g: f64,
}
