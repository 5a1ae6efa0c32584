use liftoff::prelude::*;

/// Two equal bars, hinged at D, lie across a gap of width `l` on two smooth corners (Fig. 1a).
///
/// ```text
///   A ────────────── D ────────────── B        φ = 0: every bar rests on its own midpoint
///           P ▲             ▲ Q
///   ▔▔▔▔▔▔▔▔▔▔▏             ▕▔▔▔▔▔▔▔▔▔▔
///             │←──── l ────→│
/// ```
///
/// The fall is symmetric: P and Q are one contact, each corner bearing half of it.
#[liftoff::document]
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(y = -y(D))]
#[mirror(x = 0)]
pub struct FallingPair {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar, and width of the gap.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
