use liftoff::prelude::*;

/// A chimney falls about its foot; S is a section so far from it.
///
/// ```text
///          ╱ A
///     │φ  ╱
///     │  S         φ from the vertical
///     │ ╱ s
///   ──O──
/// ```
///
/// The moment ¼ m g sin φ s (1 − s/l)² is largest at s = l/3, where falling chimneys break (Madsen, Am. J. Phys. 1977,
/// 45(2), 182–184).
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[section(S = OA, at = s)]
#[figure(A = (3 * l / 5, 4 * l / 5))]
#[coordinate(phi = angle(OA), from = vertical)]
pub struct Chimney {
    /// Mass.
    pub m: f64,
    /// Height.
    pub l: f64,
    /// Distance of the section from the foot.
    pub s: f64,
    /// Gravity.
    pub g: f64,
}
