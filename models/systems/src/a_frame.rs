use liftoff::prelude::*;

/// Two equal bars hinged at the apex C, their feet on a smooth floor.
///
/// ```text
///          C
///         ╱ ╲
///        ╱   ╲
///       ╱     ╲ φ to the floor
///   ▔▔▔A▔▔▔▔▔▔▔B▔▔▔
/// ```
///
/// The fall is symmetric: A and B are one contact, each foot bearing half of it. `y` is the height of C.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AC, mass = m, length = l)]
#[bar(CB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = floor)]
#[figure(C = (0, 4 * l / 5), B = (3 * l / 5, 0))]
#[coordinate(phi = angle(CB), from = horizontal)]
#[coordinate(y = y(C))]
#[mirror(x = 0)]
pub struct AFrame {
    /// Mass of one bar.
    pub m: f64,
    /// Length of one bar.
    pub l: f64,
    /// Gravity.
    pub g: f64,
}
