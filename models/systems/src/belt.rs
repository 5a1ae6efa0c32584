use liftoff::prelude::*;

/// A block on a moving belt, held back by a spring: it sticks, slips back, and sticks again.
///
/// ```text
///          k   ┌───┐
///   O│╱╲╱╲╱╲╱╲─│ P │
///   ─────────▔▔▔▔▔▔▔▔▔▔  w →
///      l       x
/// ```
///
/// It slips at k x = μₛ m g and slides as an oscillator about x = μ m g/k until it has the speed of the belt, at
/// k x = (2 μ − μₛ) m g. With the belt at rest it is the friction oscillator: each turning point lies 2 μ m g/k nearer.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (-l, 0))]
#[spring(OP, stiffness = k, length = l)]
#[support(P = floor, friction = mu, static = mu_s, moving = w)]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
pub struct Belt {
    /// Mass of the block.
    pub m: f64,
    /// Length of the spring without load.
    pub l: f64,
    /// Stiffness of the spring.
    pub k: f64,
    /// Friction of the block that slides.
    pub mu: f64,
    /// Friction of the block that sticks.
    pub mu_s: f64,
    /// Speed of the belt.
    pub w: f64,
    /// Gravity.
    pub g: f64,
}
