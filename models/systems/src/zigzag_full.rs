use liftoff::prelude::*;

/// The whole four-bar chain of Fig. 1b with nothing assumed about symmetry: five contacts.
///
/// ```text
///        B         D
///       ╱ ╲       ╱ ╲
///      ╱   ╲     ╱   ╲        one angle to the floor for every bar
///     ╱     ╲   ╱     ╲
///    A       ╲ ╱       E
///   ▔▔▔▔▔▔▔▔▔▔C▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// `x` and `y` are the position of C.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m2, length = l)]
#[bar(BC, mass = m1, length = l)]
#[bar(CD, mass = m1, length = l)]
#[bar(DE, mass = m2, length = l)]
#[support(A = floor)]
#[support(C = floor)]
#[support(E = floor)]
#[support(B = floor, stop)]
#[support(D = floor, stop)]
#[figure(
    A = (-6 * l / 5, 0),
    B = (-3 * l / 5, 4 * l / 5),
    C = (0, 0),
    D = (3 * l / 5, 4 * l / 5),
    E = (6 * l / 5, 0),
)]
#[coordinate(phi_ab = angle(AB), from = horizontal)]
#[coordinate(phi_bc = angle(BC), from = horizontal)]
#[coordinate(phi_cd = angle(CD), from = horizontal)]
#[coordinate(phi_de = angle(DE), from = horizontal)]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
pub struct ZigzagFull {
    /// Mass of an inner bar, BC or CD.
    pub m1: f64,
    /// Mass of an outer bar, AB or DE.
    pub m2: f64,
    /// Length of one bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
