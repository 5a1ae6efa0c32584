use liftoff::prelude::*;

/// Two bars hinged at the apex D, feet A, B on a smooth floor, mirrored: φ to the floor, h the height of D.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = floor)]
#[figure(D = (0, sqrt(3) * l / 2), B = (l / 2, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(h = y(D))]
#[mirror(x = 0)]
pub struct AFrame {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}
