use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AC, mass = m, length = l)]
#[bar(CB, mass = 2 * m, length = l)]
#[support(A = floor)]
#[figure(A = (-l / 2, 0), C = (0, l * sqrt(3) / 2), B = (l / 2, 0))]
#[mirror(x = 0)]
struct AFrame {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
