//! A model whose loads are chosen, turn and are looked up.

use liftoff::prelude::*;
use liftoff_studio::models;
use liftoff_studio::registry::Entry;

/// A pendulum beside a mass that pushes and pulls itself along.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[particle(P, mass = m)]
#[couple(OA = -c * l * atan2(y(A), x(A)) - c * l * atan(x(A) / l))]
#[force(P = (c * table(t, [0, 1, 2.5, 3], [1, 0.5, -1, 2]), m * g - if(x(P) > l || t > 2, c, 2 * c) * sign(y(P))))]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(A = (0, -l), P = (l, 0))]
#[run(start = "phi = 1, phi' = 9, x = 0, y = 0.4", limit = 4)]
struct Chosen {
    #[value = 1.2]
    m: f64,
    #[value = 0.8]
    l: f64,
    #[value = 9.81]
    g: f64,
    #[value = 0.7]
    c: f64,
}

pub fn models() -> Vec<Entry> {
    models![Chosen].iter().cloned().collect()
}
