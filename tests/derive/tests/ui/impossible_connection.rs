use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[bar(CD, mass = m, length = l)]
#[pin(A = (0, 0))]
#[figure(B = (l, 0), C = (8 * l / 5, 4 * l / 5))]
#[weld(AB, CD, angle = 0)]
#[weld(AB, BC)]
#[slider(B = bar(AB))]
#[thread(rope = A -> C -> D, length = l)]
#[spring(BC, stiffness = k)]
#[slider(E = horizontal(0))]
struct Linkage {
    m: f64,
    l: f64,
    g: f64,
    k: f64,
}

fn main() {}
