use liftoff::prelude::*;

/// Four bars in the shape of an M on a smooth floor, every support watched on its own (Fig. 1b, strict).
///
/// ```text
///        B         D
///       ╱ ╲       ╱ ╲
///      ╱   ╲     ╱   ╲        φ_inner: BC and CD to the floor
///     ╱     ╲   ╱     ╲       φ_outer: AB and DE to the floor
///    A       ╲ ╱       E
///   ▔▔▔▔▔▔▔▔▔▔C▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// The motion is symmetric: A and E are one contact, so are B and D. `y` is the rise of C.
#[liftoff::document]
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
#[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))]
#[coordinate(phi_inner = angle(CD), from = horizontal)]
#[coordinate(phi_outer = angle(DE), from = horizontal)]
#[coordinate(y = y(C))]
#[mirror(x = 0)]
pub struct Zigzag {
    /// Mass of an inner bar, BC or CD.
    pub m1: f64,
    /// Mass of an outer bar, AB or DE.
    pub m2: f64,
    /// Length of one bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
