use liftoff::prelude::*;

/// The rod BC hangs from B, and nothing gives it inertia or holds its end.
#[derive(BarSystem)]
#[gravity(g)]
#[pin(A = (0, 0))]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = 0, length = l)]
#[figure(B = (0, -l), C = (0, -2 * l))]
struct Hanging {
    m: f64,
    l: f64,
    g: f64,
}

fn main() {}
