use liftoff::prelude::*;

/// Fig. 1a with nothing assumed about symmetry, and its shoulders: beside the gap an end lies on
/// the floor.
///
/// ```text
///   A ────────────── D ────────────── B
///           P ▲             ▲ Q
///   ▔▔▔▔▔▔▔▔▔▔▏             ▕▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// Both angles are positive while the hinge is below; `y` is the drop of D, `x` its shift to the
/// right.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[support(left = floor, under = A, while("x(A) < -l / 2"))]
#[support(right = floor, under = B, while("x(B) > l / 2"))]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi_left = -angle(AD), from = right)]
#[coordinate(phi_right = angle(DB), from = right)]
#[coordinate(x = x(D))]
#[coordinate(y = -y(D))]
pub struct FallingPairShoulders {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar, and width of the gap.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
