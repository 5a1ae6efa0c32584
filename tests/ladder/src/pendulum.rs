//! The same with a pin.

use liftoff::BarSystem;

use crate::GRAVITY;

/// A bar that swings about its end.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(B = (0, -l))]
#[coordinate(phi = angle(OB), from = down)]
pub struct Pendulum {
    /// Mass.
    pub m: f64,
    /// Length.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}

impl Pendulum {
    /// The scene of the programs.
    pub const SCENE: Self = Self { m: 1.0, l: 1.0, g: GRAVITY };
}
