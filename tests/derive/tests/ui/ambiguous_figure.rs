use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[pin(A = (0, 0))]
#[pin(C = (l, 0))]
struct Loop {
    m: f64,
    l: f64,
    g: f64,
}

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0))]
#[figure(A = (l, 0))]
#[coordinate(phi = angle(AB), from = horizontal)]
struct Ladder {
    m: f64,
    l: f64,
    g: f64,
}

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
struct Nowhere {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
