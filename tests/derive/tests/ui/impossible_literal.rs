use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = 0)]
#[bar(BC, mass = -2.5, length = l)]
#[bar(CD, mass = m, length = 1 - 3)]
#[mass(D, -1)]
#[pin(A = (0, 0))]
struct Chain {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
