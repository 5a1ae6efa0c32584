use liftoff::prelude::*;

/// Two hinged bars.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l), B = (0, -2 * l))]
#[coordinate(a = angle(OA), from = down)]
#[coordinate(b = angle(AB), from = down)]
pub struct DoublePendulum {
    pub m: f64,
    pub l: f64,
    pub g: f64,
}
