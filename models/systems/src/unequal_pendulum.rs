use liftoff::prelude::*;

/// Two bars of one length and two masses, the first hinged at O, the second at its end A.
///
/// ```text
///   ──O──
///     │╲
///     │ ╲ phi_1, m1
///     │  A
///        │╲
///        │ ╲ phi_2, m2      both from the downward vertical
///        │  B
/// ```
///
/// The upper bar may be massless; without mass the lower one has no motion of its own.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m1, length = l)]
#[bar(AB, mass = m2, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l), B = (0, -2 * l))]
#[coordinate(phi_1 = angle(OA), from = down)]
#[coordinate(phi_2 = angle(AB), from = down)]
pub struct UnequalPendulum {
    /// Mass of the upper bar.
    pub m1: f64,
    /// Mass of the lower bar.
    pub m2: f64,
    /// Length of one bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
