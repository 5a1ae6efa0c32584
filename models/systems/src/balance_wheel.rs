use liftoff::prelude::*;

/// The balance wheel of a watch: a hairspring turns it back, friction slows it, and the escapement pushes it while it turns forwards.
///
/// ```text
///        ▔▔▔O▔▔▔ A      a wheel of moment J about O, spring k, damping c
///           ↺           the escapement's couple `push` while φ' > 0
/// ```
///
/// Whatever the start, the swing becomes that of one amplitude: with the damping ratio ζ and e = exp(−πζ/√(1 − ζ²)) it turns as far as
/// push / (k (1 − e)) forwards.
#[derive(BarSystem, Clone, Debug)]
#[bar(wheel = O -> A, mass = m, length = r, centre = 0, inertia = inertia)]
#[pin(O = (0, 0))]
#[figure(A = (r, 0))]
#[coordinate(phi = angle(wheel), from = horizontal)]
#[torsion(wheel, stiffness = k, damping = c)]
#[couple(escapement = push, on = wheel, while("phi' > 0"))]
pub struct BalanceWheel {
    /// Mass of the wheel.
    pub m: f64,
    /// Its moment of inertia about its axis.
    pub inertia: f64,
    /// Its radius.
    pub r: f64,
    /// Stiffness of the hairspring.
    pub k: f64,
    /// Damping.
    pub c: f64,
    /// What the escapement pushes with.
    pub push: f64,
}
