//! Two models in one file, one of them deeper.

use liftoff::prelude::*;

/// A ball that falls on a floor.
#[derive(BarSystem)]
#[gravity(9.81)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = 0.5)]
#[figure(P = (0, 1))]
#[run(limit = 0.6)]
struct Ball {
    #[value(1)]
    m: f64,
}

mod inside {
    /// A bar whose length nobody tells.
    #[derive(BarSystem)]
    #[gravity(g)]
    #[bar(OA, mass = 1, length = l)]
    #[pin(O = (0, 0))]
    #[figure(A = (0, -l))]
    struct LongBar {
        l: f64,
        #[value = 9.81]
        g: f64,
    }
}
