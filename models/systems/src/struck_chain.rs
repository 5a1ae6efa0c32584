use liftoff::prelude::*;

/// Two equal hinged bars lie straight on a table, seen from above; one end is struck.
///
/// ```text
///   A ────────── B ────────── C
///                             ↑ J
/// ```
///
/// A blow J across the bars at C leaves the hinge J/4 and gives C the velocity 7J/2m.
#[derive(BarSystem, Clone, Debug)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[figure(A = (0, 0), B = (l, 0), C = (2 * l, 0))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(alpha = angle(AB))]
#[coordinate(beta = angle(BC))]
pub struct StruckChain {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar.
    pub l: f64,
}
