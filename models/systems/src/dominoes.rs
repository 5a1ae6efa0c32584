use liftoff::prelude::*;

/// Four dominoes in a row: the first leans, falls against the second, and so on.
///
/// ```text
///         ╱╱ C     H┌┐G   M┌┐L   R┌┐Q
///        ╱╱         ││     ││     ││
///     D ╱╱          ││     ││     ││
///       ╲B          E┘F    J┘K    N┘P
/// ▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔
/// ```
///
/// Faces are smooth. Where the feet do not slip, a plastic blow at height y turns both about them, J y = I (ω − ω′) = I ω′, so that
/// either has half the rate of the first; the first goes on pushing. A real floor lets the feet slip in the blow.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[body(one, points(A = (0, 0), B = (w, 0), C = (w, h), D = (0, h)), mass = m, inertia = m * (w * w + h * h) / 12, centre = (w / 2, h / 2))]
#[body(two, points(E = (0, 0), F = (w, 0), G = (w, h), H = (0, h)), mass = m, inertia = m * (w * w + h * h) / 12, centre = (w / 2, h / 2))]
#[body(three, points(J = (0, 0), K = (w, 0), L = (w, h), M = (0, h)), mass = m, inertia = m * (w * w + h * h) / 12, centre = (w / 2, h / 2))]
#[body(four, points(N = (0, 0), P = (w, 0), Q = (w, h), R = (0, h)), mass = m, inertia = m * (w * w + h * h) / 12, centre = (w / 2, h / 2))]
#[support(A = floor, friction = mu)]
#[support(B = floor, friction = mu)]
#[support(E = floor, friction = mu)]
#[support(F = floor, friction = mu)]
#[support(J = floor, friction = mu)]
#[support(K = floor, friction = mu)]
#[support(N = floor, friction = mu)]
#[support(P = floor, friction = mu)]
#[support(Q = floor, friction = mu)]
#[support(C = edge(E, H))]
#[support(G = edge(J, M))]
#[support(L = edge(N, R))]
#[figure(
    A = (0, 0), B = (w, 0), C = (w, h), D = (0, h),
    E = (w + s, 0), F = (2 * w + s, 0), G = (2 * w + s, h), H = (w + s, h),
    J = (2 * w + 2 * s, 0), K = (3 * w + 2 * s, 0), L = (3 * w + 2 * s, h), M = (2 * w + 2 * s, h),
    N = (3 * w + 3 * s, 0), P = (4 * w + 3 * s, 0), Q = (4 * w + 3 * s, h), R = (3 * w + 3 * s, h),
)]
#[coordinate(phi = angle(one), from = right)]
#[coordinate(psi = angle(two), from = right)]
#[coordinate(chi = angle(three), from = right)]
#[coordinate(theta = angle(four), from = right)]
#[coordinate(x = x(B))]
#[coordinate(y = y(B))]
#[liftoff(sets = 0)]
pub struct Dominoes {
    /// Mass of a domino.
    pub m: f64,
    /// Its width.
    pub w: f64,
    /// Its height.
    pub h: f64,
    /// From one to the next.
    pub s: f64,
    /// Friction of the floor.
    pub mu: f64,
    /// Gravity.
    pub g: f64,
}
