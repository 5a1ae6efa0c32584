use liftoff::prelude::*;

/// A trebuchet: a falling weight throws a stone from a sling that drags it along a trough first.
///
/// ```text
///            ╱A
///          O╱ │
///         ╱╲  W        weight on a hinged chest A–W
///        ╱  ╲
///      B╱____╲__P      sling B–P, the stone P in the trough
///    ▔▔▔▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// The stone leaves the trough where its normal force vanishes; the sling lets go where the beam has come to `release` from hanging down.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(beam = A -> B, mass = m, length = a + b)]
#[point(O = beam, at = a)]
#[pin(O = (0, 3 * b / 5))]
#[bar(chest = A -> W, mass = weight, length = c, centre = c, inertia = weight * c * c / 6)]
#[particle(P, mass = stone)]
#[thread(sling = B -> P, length = s, while("theta > -release"))]
#[support(P = floor)]
#[figure(A = (4 * a / 5, 3 * (a + b) / 5), B = (-4 * b / 5, 0), W = (4 * a / 5, 3 * (a + b) / 5 - c), P = (s - 4 * b / 5, 0))]
#[coordinate(theta = angle(beam), from = down)]
#[coordinate(psi = angle(chest), from = down)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
pub struct Trebuchet {
    /// Mass of the beam.
    pub m: f64,
    /// Mass of the weight.
    pub weight: f64,
    /// Mass of the stone.
    pub stone: f64,
    /// Short arm.
    pub a: f64,
    /// Long arm.
    pub b: f64,
    /// From the short arm's end to the middle of the weight.
    pub c: f64,
    /// Length of the sling.
    pub s: f64,
    /// Angle of the beam at which the sling lets go.
    pub release: f64,
    /// Gravity.
    pub g: f64,
}
