//! The tutorial's model as a program of its own: every command over one folding step ladder.

use liftoff::prelude::*;
use liftoff::scene::{Scene, Setup};

/// A folding step ladder on a smooth floor, somebody on its top: its feet slip apart.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AC, mass = m, length = l)]
#[bar(CB, mass = m, length = l)]
#[mass(C, p)]
#[support(A = floor)]
#[support(B = floor)]
#[figure(A = (-l / 4, 0), B = (l / 4, 0), C = (0, sqrt(15) * l / 4))]
#[coordinate(alpha = angle(AC), from = horizontal)]
#[coordinate(beta = angle(CB), from = horizontal)]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
struct StepLadder {
    /// Mass of a leg, kg.
    m: f64,
    /// Mass on the top, kg.
    p: f64,
    /// Length of a leg, m.
    l: f64,
    /// Gravity, m/s².
    g: f64,
}

impl Scene for StepLadder {
    fn setup() -> Setup {
        Setup::with(&[("m", 6.0), ("p", 70.0), ("l", 2.0), ("g", 9.81)]).until("y(C) = 0")
    }
}

fn main() {
    liftoff::cli::run(liftoff::models![StepLadder])
}
