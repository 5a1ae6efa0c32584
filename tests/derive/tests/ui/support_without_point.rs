use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(C = floor)]
#[support(heel = floor, under = E)]
#[support(P = corner(0, 0), under = AC)]
#[figure(A = (0, 0), B = (3 * l / 5, 4 * l / 5))]
struct Rod {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
