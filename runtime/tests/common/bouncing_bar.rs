use liftoff::prelude::*;

/// A bar over a smooth floor; φ its angle to the floor, (x, y) the position of A.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, restitution = e)]
#[support(B = floor, restitution = e)]
#[figure(A = (0, l), B = (4 * l / 5, 8 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
pub struct BouncingBar {
    pub m: f64,
    pub l: f64,
    pub g: f64,
    pub e: f64,
}
