use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[pin(A = (-l / 2, 0))]
#[pin(C = (l / 2, 0))]
#[figure(B = (0, l * sqrt(3) / 2))]
struct Truss {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
