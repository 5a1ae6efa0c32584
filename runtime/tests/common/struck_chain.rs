use liftoff::prelude::*;

/// Two equal bars in line, hinged at B, free but for a floor far below (catalogue 11).
#[derive(BarSystem, Clone, Debug)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[support(A = floor)]
#[figure(A = (0, 10 * l), B = (l, 10 * l), C = (2 * l, 10 * l))]
#[coordinate(theta_AB = angle(AB), from = right)]
#[coordinate(theta_BC = angle(BC), from = right)]
#[coordinate(x = x(B))]
#[coordinate(y = y(B))]
pub struct StruckChain {
    pub m: f64,
    pub l: f64,
}
