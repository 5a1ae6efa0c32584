use liftoff::prelude::*;

/// A pendulum hangs from a cart on a smooth rail.
///
/// ```text
///   ══[C]══════
///       ╲ φ
///        ╲
///         P
/// ```
///
/// No horizontal force acts: `px` and with it the centre of mass keep their speed.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(CP, mass = m, length = l)]
#[mass(C, a)]
#[slider(C = horizontal(0))]
#[figure(C = (0, 0), P = (0, -l))]
#[coordinate(x = x(C))]
#[coordinate(phi = angle(CP), from = down)]
pub struct CartPendulum {
    /// Mass of the cart.
    pub a: f64,
    /// Mass of the pendulum.
    pub m: f64,
    /// Length of the pendulum.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
