use liftoff::prelude::*;

/// Painlevé's rod slides on its tip, as chalk does that is pushed over a board.
///
/// ```text
///        ╱ B
///       ╱
///      ╱ θ
///   ▔▔A▔▔▔▔▔▔   ← ẋ
/// ```
///
/// While the tip slides to the left, N (1 + 3 cos² θ − 3 μ sin θ cos θ) = m (g − ½ l θ̇² sin θ). For μ > 4/3 the factor is negative where
/// tan θ lies between (3 μ ± √(9 μ² − 16))/2: there no reaction obeys the law of friction, or two do. An impact without collision
/// ends the slip (Génot and Brogliato, Eur. J. Mech. A/Solids 18, 1999, 653–677).
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu, restitution = e, law = stronge)]
#[figure(A = (0, 0), B = (3 * l / 5, 4 * l / 5))]
#[coordinate(theta = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct Painleve {
    /// Mass of the rod.
    pub m: f64,
    /// Length of the rod.
    pub l: f64,
    /// Friction of the floor.
    pub mu: f64,
    /// Restitution: e² of the work of compression is given back.
    pub e: f64,
    /// Gravity.
    pub g: f64,
}
