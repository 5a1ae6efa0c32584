use liftoff::prelude::*;

/// Fig. 1b with the thread that holds B and D: cut, it lets the four bars fall.
///
/// ```text
///        B ─────── D
///       ╱ ╲   s   ╱ ╲
///      ╱   ╲     ╱   ╲        φ_inner: BC and CD to the floor
///     ╱     ╲   ╱     ╲       φ_outer: AB and DE to the floor
///    A       ╲ ╱       E
///   ▔▔▔▔▔▔▔▔▔▔C▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// At rest with all angles φ its tension is ½ (m1 + m2) g cot φ, s = 2 l cos φ.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m2, length = l)]
#[bar(BC, mass = m1, length = l)]
#[bar(CD, mass = m1, length = l)]
#[bar(DE, mass = m2, length = l)]
#[thread(BD, length = s)]
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
pub struct ZigzagThread {
    /// Mass of an inner bar, BC or CD.
    pub m1: f64,
    /// Mass of an outer bar, AB or DE.
    pub m2: f64,
    /// Length of one bar.
    pub l: f64,
    /// Length of the thread.
    pub s: f64,
    /// Gravity.
    pub g: f64,
}
