use liftoff::BarSystem;

#[derive(BarSystem)]
enum Choice {
    Pendulum,
}

#[derive(BarSystem)]
struct Tuple(f64);

#[derive(BarSystem)]
struct Generic<T> {
    m: T,
}

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
struct Single {
    m: f32,
    l: f64,
    #[mass(B, m)]
    g: f64,
}

fn main() {}
