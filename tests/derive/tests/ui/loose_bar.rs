use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(CD, mass = m, length = l)]
#[pin(A = (0, 0))]
#[figure(C = (l, 0))]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
