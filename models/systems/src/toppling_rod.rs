use liftoff::prelude::*;

/// A rod topples about a rough point, which it never leaves though its reaction touches zero.
///
/// ```text
///        ╱ B
///     │φ╱
///     │╱
///   ▒▒A▒▒▒▒▒▒       φ from the vertical
/// ```
///
/// From rest upright N = ¼ mg (1 − 3 cos φ)²; where cos φ = ⅓ it is zero for an instant. `ratio(A)` is the friction
/// that a floor must have.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, rough)]
#[figure(A = (0, 0), B = (3 * l / 5, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = vertical)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct TopplingRod {
    /// Mass of the rod.
    pub m: f64,
    /// Length of the rod.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
