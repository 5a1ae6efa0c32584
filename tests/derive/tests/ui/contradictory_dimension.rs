use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[support(A = floor(m))]
#[force(wind = (f * l, f), at = A)]
#[couple(OA = m * g + k)]
#[torsion(OA, stiffness = k * sin(g))]
#[figure(A = (l, 0))]
struct Pendulum {
    m: f64,
    l: f64,
    f: f64,
    k: f64,
    g: f64,
}

fn main() {}
