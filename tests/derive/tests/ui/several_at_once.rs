use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(gg)]
#[bar(AB, mass = -1, length = l)]
#[bar(BC, mass = m, length = l + k)]
#[bar(BC, mass = m, length = l)]
#[bar(EF, mass = m, length = l)]
#[support(D = floor)]
#[pin(A = (0, 0))]
#[figure(E = (l, 0))]
#[coordinate(phi = angle(CB), from = down)]
struct Chain {
    m: f64,
    l: f64,
    g: f64,
    friction: f64,
}

fn main() {}
