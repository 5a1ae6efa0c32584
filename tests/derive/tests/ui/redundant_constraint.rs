use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[pin(A = (0, 0))]
#[equal(angle(AB), angle(BC))]
#[equal(angle(BC), angle(AB))]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
