use liftoff_derive::BarSystem;

#[derive(BarSystem)]
#[liftoff(crate = liftoff_core)]
#[bar(AB, mass = m, length = l)]
#[coordinate(phi = angle(AC))]
#[pin(A = (0, 0))]
struct Rod {
    m: f64,
    l: f64,
}

fn main() {
    println!("{} {} {}", Rod::PHI, Rod::PHI.rate(), Rod::A);
}
