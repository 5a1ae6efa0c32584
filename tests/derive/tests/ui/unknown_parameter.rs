use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = 2 * (lenght + m / g))]
#[pin(A = (0, 0))]
struct Pendulum {
    m: f64,
    length: f64,
    g: f64,
}

fn main() {}
