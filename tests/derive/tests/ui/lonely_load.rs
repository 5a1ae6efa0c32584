use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(A = floor, rough)]
#[support(B = floor)]
#[force(A = (f, 0))]
#[figure(A = (-3 * l / 5, 0), D = (0, 4 * l / 5))]
#[mirror(x = 0)]
struct Frame {
    m: f64,
    l: f64,
    g: f64,
    f: f64,
}

fn main() {}
