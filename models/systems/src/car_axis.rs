use liftoff::prelude::*;

/// The car axis of the Test Set for IVP Solvers: half a car that rolls over a bump, one wheel at rest and one lifted.
///
/// ```text
///     N
///     │
///     L═══════════R     LR: the chassis, half its mass m at each end
///     ⌇           ⌇     ON: what L slides along, square to the axis
///     ⌇           ⌇
///     O───────────B     OB: the axis, B at the height r sin ωt
/// ```
///
/// Numbers: Mazzia & Magherini, Test Set for Initial Value Problem Solvers, release 2.4, problem `caraxis`: there
/// m = M, k = 1/ε², h = L₀, and its forces are divided by k.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OB, mass = 0, length = l)]
#[bar(ON, mass = 0, length = h)]
#[weld(OB, ON)]
#[pin(O = (0, 0))]
#[drive(y(B) = r * sin(omega * t))]
#[bar(LR, mass = m, length = l, centre = l / 2, inertia = m * l * l / 4)]
#[slider(L = bar(ON))]
#[spring(OL, stiffness = k, length = h)]
#[spring(BR, stiffness = k, length = h)]
#[figure(B = (l, 0), N = (0, h), L = (0, h), R = (l, h))]
#[coordinate(tilt = angle(OB))]
#[coordinate(theta = angle(LR))]
pub struct CarAxis {
    /// Mass of the chassis.
    pub m: f64,
    /// Length of the axis and of the chassis.
    pub l: f64,
    /// Length of the springs.
    pub h: f64,
    /// Stiffness of the springs.
    pub k: f64,
    /// How far the wheel is lifted.
    pub r: f64,
    /// Rate at which it goes up and down.
    pub omega: f64,
    /// Gravity.
    pub g: f64,
}
