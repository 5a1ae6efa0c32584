//! A program as a user would write it, for the tests beside it.

use liftoff::prelude::*;
use liftoff_cli::{DefaultRun, RunSpec};

/// A folding trestle on a smooth floor, a load on its top: its feet slip apart.
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
struct Trestle {
    /// Mass of a leg, kg.
    m: f64,
    /// Mass on the top, kg.
    p: f64,
    /// Length of a leg, m.
    l: f64,
    /// Gravity, m/s².
    g: f64,
}

impl DefaultRun for Trestle {
    fn default_run() -> RunSpec {
        RunSpec::with(&[("m", 6.0), ("p", 70.0), ("l", 2.0), ("g", 9.81)]).until("y(C) = 0")
    }
}

fn main() {
    liftoff_cli::run(liftoff_cli::models![Trestle])
}
