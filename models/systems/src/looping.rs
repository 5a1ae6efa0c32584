use liftoff::prelude::*;

/// A marble in a smooth upright ring: too slow, it falls off the track before the top.
///
/// ```text
///     ╭─────╮
///    ╱       ╲
///   │    +    │ r
///    ╲       ╱
///     ╰──P──╯
/// ```
///
/// Started below with the speed v it leaves where the height above the centre is (v² − 2 g r)/(3 g), and stays on
/// where that exceeds r.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = bowl((0, 0), r), stop)]
#[figure(P = (3 * r / 5, -4 * r / 5))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
pub struct Looping {
    /// Mass.
    pub m: f64,
    /// Radius.
    pub r: f64,
    /// Gravity.
    pub g: f64,
}
