use liftoff::prelude::*;

/// Two stiff legs and a hip walk down a slope by themselves.
///
/// ```text
///            H
///           ╱ ╲
///      b   G   K
///         ╱     ╲
///      a A       B          γ below the horizontal, to the right
/// ▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// Stiff legs of one length scuff where they pass each other. As in the first machines (McGeer, Int. J. Robotics Res. 9(2), 1990,
/// 62–82) the feet tread on tiles: A on those about the even multiples of `s`, B on those about the odd ones, and between them
/// nothing is under them.
///
/// The gait of the defaults is that of Goswami, Thuilot and Espiau, *A study of the passive gait of a compass-like biped robot*,
/// Int. J. Robotics Res. 17(12), 1998, 1282–1301, on their slope of 3°: it comes back after every step, and from starts beside it.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(HA, mass = m, length = a + b, centre = b, inertia = j)]
#[bar(HB, mass = m, length = a + b, centre = b, inertia = j)]
#[mass(H, hip)]
#[support(A = slope(-gamma), rough, while("cos(pi * x(A) / s) > 0"))]
#[support(B = slope(-gamma), rough, while("cos(pi * x(B) / s) < 0"))]
#[constant(h = s / (2 * cos(gamma)))]
#[constant(k = sqrt((a + b).powi(2) - h.powi(2)))]
#[figure(A = (0, 0), H = (h * cos(gamma) + k * sin(gamma), k * cos(gamma) - h * sin(gamma)), B = (s, -2 * h * sin(gamma)))]
#[coordinate(left = angle(HA), from = down)]
#[coordinate(right = angle(HB), from = down)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct CompassWalker {
    /// Mass of a leg.
    pub m: f64,
    /// Mass of the hip.
    pub hip: f64,
    /// Moment of inertia of a leg about its centre of mass.
    pub j: f64,
    /// From a foot to the centre of mass of its leg.
    pub a: f64,
    /// From there to the hip.
    pub b: f64,
    /// Angle of the slope.
    pub gamma: f64,
    /// Horizontal distance of tiles.
    pub s: f64,
    /// Gravity.
    pub g: f64,
}
