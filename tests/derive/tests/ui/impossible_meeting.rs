//! Bodies that cannot meet as declared, discs and drives of nothing.

use liftoff::prelude::*;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[pin(A = (0, 0))]
#[particle(P, mass = m)]
#[disc(P, radius = 0)]
#[disc(B, radius = r)]
#[support(B = bar(AB))]
#[support(C = edge(A, P))]
#[support(P = disc(C))]
#[support(Q = bar(BC), under = P)]
#[slider(P = horizontal(0), stops)]
#[drive(distance(A, B) = l)]
#[drive(along(P, CB) = l)]
#[equal(angle(AB), 1.5 * angle(BC))]
#[figure(B = (l, 0), C = (2 * l, 0), P = (3 * l, 0))]
struct Meeting {
    m: f64,
    l: f64,
    r: f64,
    g: f64,
}

fn main() {}
