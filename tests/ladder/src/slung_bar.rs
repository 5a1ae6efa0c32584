//! The falling bar on a thread that slips through an eye.

use liftoff::BarSystem;

use crate::GRAVITY;

/// A bar hangs by a thread from A through the eye E, the origin, to B; its centre at (x, y).
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(C = AB, at = l / 2)]
#[ground(E = (0, 0))]
#[thread(rope = A -> E -> B, length = s)]
#[figure(A = (-l / 2, -2 * l / 3), B = (l / 2, -2 * l / 3))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
pub struct SlungBar {
    /// Mass.
    pub m: f64,
    /// Length.
    pub l: f64,
    /// Length of the thread.
    pub s: f64,
    /// Gravity.
    pub g: f64,
}

impl SlungBar {
    /// The scene of the programs: A, E and B make two triangles of sides 3, 4, 5.
    pub const SCENE: Self = Self { m: 1.0, l: 1.0, s: 5.0 / 3.0, g: GRAVITY };
}
