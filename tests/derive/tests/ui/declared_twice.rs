use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[point(G = AB, at = l / 2)]
#[point(G = AB, at = l / 3)]
#[pin(A = (0, 0))]
#[coordinate(phi = angle(AB))]
#[coordinate(l = y(B))]
#[constant(m = 2 * g)]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
