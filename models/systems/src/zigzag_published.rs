use liftoff::prelude::*;

/// Four bars in the shape of an M, all four angles kept equal, as the paper has it (Fig. 1b).
///
/// ```text
///        B         D
///       ╱ ╲       ╱ ╲
///      ╱   ╲     ╱   ╲        φ: every bar to the floor
///     ╱     ╲   ╱     ╲
///    A       ╲ ╱       E
///   ▔▔▔▔▔▔▔▔▔▔C▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// The gaps of A, C and E are one function, hence one contact: only the total reaction is determined. `y` is the drop of C, downward
/// as in the paper.
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
#[coordinate(phi = angle(CD), from = horizontal)]
#[coordinate(y = -y(C))]
#[equal(angle(AB), angle(CD))]
#[mirror(x = 0)]
pub struct ZigzagPublished {
    /// Mass of an inner bar, BC or CD.
    pub m1: f64,
    /// Mass of an outer bar, AB or DE.
    pub m2: f64,
    /// Length of one bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
