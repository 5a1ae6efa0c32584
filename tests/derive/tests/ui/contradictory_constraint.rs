use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(psi = angle(BC), from = up)]
#[bar(BC, mass = m, length = l)]
#[equal(phi, psi)]
#[equal(angle(AB), angle(BC))]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
