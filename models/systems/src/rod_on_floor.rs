use liftoff::prelude::*;

/// A bar topples on a smooth floor; its foot slips and never lifts.
///
/// ```text
///        ╱ B
///     │φ╱
///     │╱
///   ▔▔A▔▔▔▔▔▔       φ from the vertical
/// ```
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[figure(A = (0, 0), B = (3 * l / 5, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = vertical)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct RodOnFloor {
    /// Mass of the bar.
    pub m: f64,
    /// Length of the bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
