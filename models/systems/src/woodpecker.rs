use liftoff::prelude::*;

/// A woodpecker climbs down a pole: the sleeve that carries it wedges itself, lets go, and falls a little.
///
/// ```text
///     ▕│      K╲__
///     ▕│┌U        ╲
///     ▕│M────G∿∿∿∿ S       a spring hinge at G
///     ▕│└L
///     ▕│
/// ```
///
/// Sleeve and bird with the masses and lengths of Leine, van Campen and Glocker, *Nonlinear dynamics and modeling of various wooden
/// toys with impact and friction*, J. Vib. Control 9, 2003, 25–78, whose gaps are linear in the angles; these are not.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[body(
    sleeve,
    points(M = (0, 0), L = (r, -h), G = (a, 0), U = (r, h)),
    mass = m_sleeve,
    inertia = j_sleeve,
    centre = (0, 0),
)]
#[body(bird, points(G = (-b, 0), S = (0, 0), K = (-d, s)), mass = m_bird, inertia = j_bird, centre = (0, 0))]
#[torsion(sleeve, bird, stiffness = c)]
#[slider(M = vertical(0))]
#[support(U = wall(r_pole), facing = right, friction = mu)]
#[support(L = wall(r_pole), facing = right, friction = mu)]
#[support(K = wall(r_pole), facing = right, friction = mu, restitution = e)]
#[figure(M = (0, 0), G = (a, 0), S = (a + b, 0))]
#[coordinate(phi = angle(sleeve), from = right)]
#[coordinate(psi = angle(bird), from = right)]
#[coordinate(y = y(M))]
pub struct Woodpecker {
    /// Mass of the sleeve.
    pub m_sleeve: f64,
    /// Moment of inertia of the sleeve.
    pub j_sleeve: f64,
    /// Mass of the bird.
    pub m_bird: f64,
    /// Moment of inertia of the bird.
    pub j_bird: f64,
    /// Stiffness of the spring hinge.
    pub c: f64,
    /// Radius of the pole.
    pub r_pole: f64,
    /// Inner radius of the sleeve.
    pub r: f64,
    /// Half the height of the sleeve.
    pub h: f64,
    /// From the middle of the sleeve to the hinge.
    pub a: f64,
    /// From the hinge to the centre of mass of the bird.
    pub b: f64,
    /// From there back to the beak.
    pub d: f64,
    /// Height of the beak above it.
    pub s: f64,
    /// Friction of the pole.
    pub mu: f64,
    /// Restitution of the beak.
    pub e: f64,
    /// Gravity.
    pub g: f64,
}
