use liftoff::prelude::*;

/// Newton's cradle: five equal balls on rods side by side, `d` apart.
///
/// ```text
///   ──O────P────Q────R────S──
///     │    │    │    │    │
///     │    │    │    │    │
///    (A)  (B)  (C)  (D)  (E)
/// ```
///
/// A real cradle passes the blow on from ball to ball: with the least distance between them each strikes the next, and the last alone flies
/// off with the rate of the first. Balls that touch, `d = 0`, are struck at once: momentum and energy leave the answer open, and the
/// laws of Newton and of Poisson with restitution 1 both turn back what approached and nothing else, so that of n balls the first comes
/// back with (2 − n)/n of its rate and all others go on with 2/n. With `e = 0` all n go on with 1/n, whatever their distance.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = l, centre = l, inertia = 2 * m * r * r / 5)]
#[bar(PB, mass = m, length = l, centre = l, inertia = 2 * m * r * r / 5)]
#[bar(QC, mass = m, length = l, centre = l, inertia = 2 * m * r * r / 5)]
#[bar(RD, mass = m, length = l, centre = l, inertia = 2 * m * r * r / 5)]
#[bar(SE, mass = m, length = l, centre = l, inertia = 2 * m * r * r / 5)]
#[pin(O = (-2 * (2 * r + d), 0))]
#[pin(P = (-2 * r - d, 0))]
#[pin(Q = (0, 0))]
#[pin(R = (2 * r + d, 0))]
#[pin(S = (2 * (2 * r + d), 0))]
#[disc(A, radius = r)]
#[disc(B, radius = r)]
#[disc(C, radius = r)]
#[disc(D, radius = r)]
#[disc(E, radius = r)]
#[support(A = disc(B), restitution = e)]
#[support(B = disc(C), restitution = e)]
#[support(C = disc(D), restitution = e)]
#[support(D = disc(E), restitution = e)]
#[figure(
    A = (-2 * (2 * r + d), -l),
    B = (-2 * r - d, -l),
    C = (0, -l),
    D = (2 * r + d, -l),
    E = (2 * (2 * r + d), -l),
)]
#[coordinate(a = angle(OA), from = down)]
#[coordinate(b = angle(PB), from = down)]
#[coordinate(c = angle(QC), from = down)]
#[coordinate(f = angle(RD), from = down)]
#[coordinate(h = angle(SE), from = down)]
pub struct NewtonsCradle {
    /// Mass of a ball.
    pub m: f64,
    /// Radius of a ball.
    pub r: f64,
    /// From the hinges to the middle of the balls.
    pub l: f64,
    /// Distance of neighbours that hang.
    pub d: f64,
    /// Restitution.
    pub e: f64,
    /// Gravity.
    pub g: f64,
}
