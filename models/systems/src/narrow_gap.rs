use liftoff::prelude::*;

/// Fig. 1a with a gap of width `w` much narrower than the bars, so that they turn nearly upright on its corners.
///
/// ```text
///   A ────────────────── D ────────────────── B
///                    P ▲   ▲ Q
///   ▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▏   ▕▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔
///                      │ w │
/// ```
///
/// While both corners touch, y = (w/2) tan φ: the pivot of the closed form is cos φ. The corners are at the bars' ends
/// where cos φ = w/2l.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-w / 2, 0), under = AD)]
#[support(Q = corner(w / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(y = -y(D))]
#[mirror(x = 0)]
pub struct NarrowGap {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar.
    pub l: f64,
    /// Width of the gap.
    pub w: f64,
    /// Gravity.
    pub g: f64,
}
