use liftoff::prelude::*;

/// A bar falls on a smooth floor and rebounds.
///
/// ```text
///            ╱ B
///          ╱ φ to the floor
///        A
///   ▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// An end that strikes at speed v without spin gets the impulse (1 + e) m v/(1 + 3 cos² φ); a level bar half of
/// (1 + e) m v at each end.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, restitution = e)]
#[support(B = floor, restitution = e)]
#[figure(A = (0, l), B = (4 * l / 5, 8 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct BouncingBar {
    /// Mass of the bar.
    pub m: f64,
    /// Length of the bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
    /// Restitution.
    pub e: f64,
}
