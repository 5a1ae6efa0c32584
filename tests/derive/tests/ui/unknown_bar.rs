use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[coordinate(phi = angle(BA), from = down)]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
