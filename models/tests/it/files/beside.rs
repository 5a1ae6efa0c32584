use liftoff::prelude::*;

/// A point beside a bar on a pin.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(CD, mass = m, length = l)]
#[pin(C = (0, 0))]
#[particle(P, mass = m)]
#[support(P = bar(CD), facing = left)]
#[figure(C = (0, 0), D = (l, 0), P = (l / 2, 0))]
#[coordinate(phi = angle(CD), from = horizontal)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Beside {
    #[value(1, unit = "kg")]
    m: f64,
    #[value(2, unit = "m")]
    l: f64,
    #[value(1, unit = "m/s²")]
    g: f64,
}
