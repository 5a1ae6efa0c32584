//! The falling bar with a support that it strikes.

use liftoff::BarSystem;

use crate::GRAVITY;

/// A bar that falls on a smooth floor and rebounds; its centre at (x, y).
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(C = AB, at = l / 2)]
#[support(A = floor, restitution = e)]
#[figure(A = (0, l), B = (3 * l / 5, 9 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
pub struct DroppedBar {
    /// Mass.
    pub m: f64,
    /// Length.
    pub l: f64,
    /// Gravity.
    pub g: f64,
    /// Restitution.
    pub e: f64,
}

impl DroppedBar {
    /// The scene of the programs.
    pub const SCENE: Self = Self { m: 1.0, l: 1.0, g: GRAVITY, e: 0.5 };
}
