use liftoff::prelude::*;

/// A bar hangs from two equal cranks and stays level: the simplest closed loop.
///
/// ```text
///   ──O───────────Q──
///      ╲           ╲
///       ╲           ╲  phi from the downward vertical
///        A ───────── B
/// ```
///
/// It swings like a pendulum, φ̈ = −(m + c) g sin φ/(l (⅔ m + c)).
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = c, length = d)]
#[bar(QB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[pin(Q = (d, 0))]
#[figure(A = (3 * l / 5, -4 * l / 5), B = (d + 3 * l / 5, -4 * l / 5))]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(QB), from = down)]
#[coordinate(tilt = angle(AB))]
pub struct Parallelogram {
    /// Mass of a crank.
    pub m: f64,
    /// Length of a crank.
    pub l: f64,
    /// Mass of the coupler.
    pub c: f64,
    /// Length of the coupler, and distance of the pins.
    pub d: f64,
    /// Gravity.
    pub g: f64,
}
