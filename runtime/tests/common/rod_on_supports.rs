use liftoff::prelude::*;

/// A level rod on three one-sided supports: A and C under its ends, B under its centre. y the height of the centre,
/// θ the tilt.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AC, mass = m, length = l)]
#[point(B = AC, at = l / 2)]
#[support(A = floor)]
#[support(B = floor)]
#[support(C = floor)]
#[figure(A = (-l / 2, 0), C = (l / 2, 0))]
#[coordinate(theta = angle(AC), from = right)]
#[coordinate(x = x(B))]
#[coordinate(y = y(B))]
pub struct RodOnSupports {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}
