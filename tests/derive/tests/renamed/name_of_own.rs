use liftoff_derive::BarSystem;

#[derive(BarSystem)]
#[liftoff(crate = liftoff_core)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
struct Rod {
    m: f64,
    l: f64,
}

impl Rod {
    const A: f64 = 1.0;
}

fn main() {}
