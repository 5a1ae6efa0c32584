//! A bar in free motion: nothing acts.

use liftoff::BarSystem;

/// A bar with its centre at (x, y).
#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[point(C = AB, at = l / 2)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
pub struct FreeBar {
    /// Mass.
    pub m: f64,
    /// Length.
    pub l: f64,
}

impl FreeBar {
    /// The scene of the programs.
    pub const SCENE: Self = Self { m: 1.0, l: 1.0 };
}
