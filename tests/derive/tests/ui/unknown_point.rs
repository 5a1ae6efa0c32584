use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(shin = knee -> foot, mass = m, length = l)]
#[pin(knee = (0, 0))]
#[figure(foot = (0, -l))]
#[coordinate(y = y(feet))]
struct Leg {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
