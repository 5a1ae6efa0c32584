use liftoff::prelude::*;

/// Fig. 1a with nothing assumed about symmetry: two corners, each its own contact.
///
/// ```text
///   A ────────────── D ────────────── B
///           P ▲             ▲ Q
///   ▔▔▔▔▔▔▔▔▔▔▏             ▕▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// Both angles are positive while the hinge is below; `y` is the drop of D, `x` its shift to the right.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi_left = -angle(AD), from = right)]
#[coordinate(phi_right = angle(DB), from = right)]
#[coordinate(x = x(D))]
#[coordinate(y = -y(D))]
pub struct FallingPairFull {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar, and width of the gap.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
