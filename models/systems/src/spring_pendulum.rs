use liftoff::prelude::*;

/// A mass on a spring that swings.
///
/// ```text
///   ──O──
///      ╲
///       ⌇  k, l, c
///        ╲
///         P
/// ```
///
/// `force(OP)` is the force of spring and damper, tension positive.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[ground(O = (0, 0))]
#[particle(P, mass = m)]
#[spring(OP, stiffness = k, length = l, damping = c)]
#[figure(P = (0, -l))]
#[coordinate(x = x(P))]
#[coordinate(y = -y(P))]
pub struct SpringPendulum {
    /// Mass.
    pub m: f64,
    /// Stiffness.
    pub k: f64,
    /// Natural length.
    pub l: f64,
    /// Damping.
    pub c: f64,
    /// Gravity.
    pub g: f64,
}
