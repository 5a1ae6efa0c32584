use liftoff::prelude::*;

/// Two equal bars, the first hinged at O, the second at its end A.
///
/// ```text
///   ──O──
///     │╲
///     │ ╲ phi_1
///     │  A
///        │╲
///        │ ╲ phi_2      both from the downward vertical
///        │  B
/// ```
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l), B = (0, -2 * l))]
#[coordinate(phi_1 = angle(OA), from = down)]
#[coordinate(phi_2 = angle(AB), from = down)]
pub struct DoublePendulum {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
