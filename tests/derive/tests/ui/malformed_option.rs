use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[body(plate, mass = m)]
#[support(A = circle(0, 0, l))]
#[support(B = floor, rough = true, law = euler)]
#[weld(AB)]
#[spring(AC, length = l)]
#[thread(rope, length = l)]
#[slider(A = horizontl(0))]
#[drive(z(A) = l)]
#[liftoff(sets = 5000)]
struct Several {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
