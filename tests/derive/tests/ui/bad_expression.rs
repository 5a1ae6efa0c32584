use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g / 0)]
#[bar(AB, mass = m % 2, length = l.exp())]
#[mass(B, sqrt(1 - 2) + 1e60)]
#[pin(A = (0, 0))]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
