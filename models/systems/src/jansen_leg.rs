use liftoff::prelude::*;

/// A leg of Theo Jansen's beach animals: a crank turns evenly, and the foot goes along the ground, lifts, and comes back.
///
/// ```text
///          B
///        ╱╱ ╲╲
///      C──Q   ╲─ A      Z–A crank, A–B and A–D rods, Q–B–C plate, Q–D and C–E links,
///      │   ╲  ╱  Z      D–E–F plate with the foot F
///      E────D
///       ╲  ╱
///        F
/// ```
///
/// Lengths: Jansen's "eleven holy numbers" (T. Jansen, *The Great Pretender*, 010 Publishers 2007), in units of `u`.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[constant(p = 216.62 / 83)]
#[constant(q = -568.6 / 73.4)]
#[bar(crank = Z -> A, mass = 15 * rho * u, length = 15 * u)]
#[bar(AB, mass = 50 * rho * u, length = 50 * u)]
#[bar(AD, mass = 61.9 * rho * u, length = 61.9 * u)]
#[bar(QD, mass = 39.3 * rho * u, length = 39.3 * u)]
#[bar(CE, mass = 39.4 * rho * u, length = 39.4 * u)]
#[body(hip, points(Q = (0, 0), B = (41.5 * u, 0), C = (p * u, u * sqrt(1608.01 - p * p))), mass = 137.4 * rho * u)]
#[body(foot, points(D = (0, 0), E = (36.7 * u, 0), F = (q * u, u * sqrt(2401 - q * q))), mass = 151.4 * rho * u)]
#[pin(Z = (0, 0))]
#[pin(Q = (-38 * u, -7.8 * u))]
#[drive(phi = omega * t)]
#[figure(
    A = (15 * u, 0),
    B = (-24 * u, 31.3 * u),
    C = (-74.8 * u, 8.1 * u),
    D = (-27 * u, -45.5 * u),
    E = (-59.2 * u, -28.1 * u),
    F = (-43.2 * u, -91.8 * u),
)]
#[coordinate(phi = angle(crank))]
pub struct JansenLeg {
    /// Mass of a unit of length.
    pub rho: f64,
    /// Unit of length.
    pub u: f64,
    /// Rate of the crank.
    pub omega: f64,
    /// Gravity.
    pub g: f64,
}
