//! The pendulum with a spring.

use liftoff::BarSystem;

use crate::GRAVITY;

/// A bar that swings about its end, the other drawn to a fixed point E.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[ground(E = (l, 0))]
#[spring(EB, stiffness = k, length = s)]
#[figure(B = (0, -l))]
#[coordinate(phi = angle(OB), from = down)]
pub struct SprungPendulum {
    /// Mass.
    pub m: f64,
    /// Length.
    pub l: f64,
    /// Gravity.
    pub g: f64,
    /// Stiffness.
    pub k: f64,
    /// Length of the spring without force.
    pub s: f64,
}

impl SprungPendulum {
    /// The scene of the programs.
    pub const SCENE: Self = Self { m: 1.0, l: 1.0, g: GRAVITY, k: 20.0, s: 0.5 };
}
