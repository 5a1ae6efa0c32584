use liftoff::prelude::*;

/// Its foot A on a smooth floor, its head B at a smooth wall; θ from the floor, (x, y) its centre.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(G = AB, at = l / 2)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[figure(A = (l / 2, 0), B = (0, sqrt(3) * l / 2))]
#[coordinate(theta = angle(AB), from = horizontal)]
#[coordinate(x = x(G))]
#[coordinate(y = y(G))]
pub struct Ladder {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}
