use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m length = l)]
#[bar(BC, mas = m, length = l)]
#[support(A = flor)]
#[figure(A = 0)]
#[coordinate(phi = angle(AB), form = horizontal)]
struct Chain {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
