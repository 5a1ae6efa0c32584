use liftoff::prelude::*;

/// A crank turns steadily and moves a piston; `drive(phi)` is the torque that this takes.
///
/// ```text
///         A
///        ╱ ╲
///     r ╱   ╲ l
///      ╱ φ   ╲  psi
///   ──O───────[B]────
/// ```
#[derive(BarSystem, Clone, Debug)]
#[bar(OA, mass = a, length = r)]
#[bar(AB, mass = b, length = l)]
#[mass(B, c)]
#[pin(O = (0, 0))]
#[slider(B = horizontal(0))]
#[figure(A = (0, r), B = (sqrt(l * l - r * r), 0))]
#[coordinate(phi = angle(OA))]
#[coordinate(psi = angle(AB))]
#[drive(phi = omega * t)]
pub struct SliderCrank {
    /// Mass of the crank.
    pub a: f64,
    /// Mass of the rod.
    pub b: f64,
    /// Mass of the piston.
    pub c: f64,
    /// Length of the crank.
    pub r: f64,
    /// Length of the rod.
    pub l: f64,
    /// Rate of the crank.
    pub omega: f64,
}
