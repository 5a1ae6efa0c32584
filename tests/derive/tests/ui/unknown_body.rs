use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[body(plate, points(A = (0, 0), B = (l, 0), C = (l, l), D = (0, l)), mass = m)]
#[support(A = floor)]
#[figure(A = (0, 0), B = (l, 0))]
struct Plate {
    m: f64,
    l: f64,
    g: f64,
}

#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[thread(rope = O -> Q, length = l)]
struct Ball {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
