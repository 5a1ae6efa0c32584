use liftoff::prelude::*;

/// A bar slides down a smooth wall, its foot on a smooth floor.
///
/// ```text
///   ▏B
///   ▏ ╲
///   ▏  ╲
///   ▏   ╲
///   ▏    ╲  φ to the floor
///   ▏▔▔▔▔▔A▔▔▔▔
/// ```
///
/// From rest it leaves the wall at sin φ = ⅔ sin φ₀, and keeps the floor.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct Ladder {
    /// Mass of the bar.
    pub m: f64,
    /// Length of the bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
