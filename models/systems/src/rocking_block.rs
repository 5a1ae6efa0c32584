use liftoff::prelude::*;

/// Housner's block rocks on its rough corners; each change of corner costs speed.
///
/// ```text
///     D─────C
///     │     │
///     │     │ h          φ: AB to the floor, counter-clockwise
///     │     │
///   ▒▒A─────B▒▒
///        b
/// ```
///
/// With tan α = b/h an impact leaves 1 − (3/2) sin² α of the rate (Housner, Bull. Seism. Soc. Am. 1963, 53(2), 403–417).
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[body(
    block,
    points(A = (0, 0), B = (b, 0), C = (b, h), D = (0, h)),
    mass = m,
    inertia = m * (b * b + h * h) / 12,
    centre = (b / 2, h / 2),
)]
#[support(A = floor, rough)]
#[support(B = floor, rough)]
#[figure(A = (0, 0), B = (b, 0))]
#[coordinate(phi = angle(block), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct RockingBlock {
    /// Mass.
    pub m: f64,
    /// Breadth.
    pub b: f64,
    /// Height.
    pub h: f64,
    /// Gravity.
    pub g: f64,
}
