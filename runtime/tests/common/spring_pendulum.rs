use liftoff::prelude::*;

/// A point mass on a spring with a damper: the equations have a root and quotients by it.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[ground(O = (0, 0))]
#[particle(P, mass = m)]
#[spring(OP, stiffness = k, length = l, damping = c)]
#[figure(P = (0, -l))]
#[coordinate(x = x(P))]
#[coordinate(y = -y(P))]
pub struct SpringPendulum {
    pub m: f64,
    pub k: f64,
    pub l: f64,
    pub c: f64,
    pub g: f64,
}
