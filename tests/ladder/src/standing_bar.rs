//! The falling bar with a support.

use liftoff::BarSystem;

use crate::GRAVITY;

/// A bar whose foot A slides on a smooth floor; its centre at (x, y).
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(C = AB, at = l / 2)]
#[support(A = floor)]
#[figure(A = (0, 0), B = (3 * l / 5, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
pub struct StandingBar {
    /// Mass.
    pub m: f64,
    /// Length.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}

impl StandingBar {
    /// The scene of the programs.
    pub const SCENE: Self = Self { m: 1.0, l: 1.0, g: GRAVITY };
}
