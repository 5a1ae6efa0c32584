use liftoff::prelude::*;

/// A level rod on three supports: how they share its weight is not determined, how it moves is.
///
/// ```text
///     A ────── C ────── B
///   ▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔
/// ```
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(C = AB, at = l / 2)]
#[support(A = floor)]
#[support(C = floor)]
#[support(B = floor)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(phi = angle(AB))]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
pub struct RodOnThree {
    /// Mass of the rod.
    pub m: f64,
    /// Length of the rod.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
