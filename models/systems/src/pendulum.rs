use liftoff::prelude::*;

/// A bar hinged at O.
///
/// ```text
///   ──O──
///     │╲
///     │φ╲        φ from the downward vertical
///     │  ╲ A
/// ```
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
pub struct Pendulum {
    /// Mass of the bar.
    pub m: f64,
    /// Length of the bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
