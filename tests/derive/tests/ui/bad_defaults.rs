use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[figure(B = (0, -l))]
#[coordinate(phi = angle(AB), from = down)]
#[value = 3.0]
#[run(start = "phi = l", until = "t = 1", end = 3)]
struct Pendulum {
    #[value(l / 2)]
    m: f64,
    #[value]
    l: f64,
    #[value(1e400)]
    #[value = 9.81]
    g: f64,
}

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = 1, length = 1)]
#[pin(A = (0, 0))]
#[figure(B = (0, -1))]
#[coordinate(phi = angle(AB), from = down)]
#[run(start = "phi = 1, psi' = 2", limit = 0)]
struct Other {
    #[value(9.81, of = "m")]
    g: f64,
}

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = 1, length = 1)]
#[pin(A = (0, 0))]
#[figure(B = (0, -1))]
#[coordinate(phi = angle(AB), from = down)]
#[run(start = "phi = 1, psi' = 2")]
struct Unknown {
    #[value(9.81, unit = "m/s²")]
    g: f64,
}

fn main() {}
