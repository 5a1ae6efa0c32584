//! A folding step ladder, by every command.

use liftoff::prelude::*;
use liftoff_cli::{DefaultRun, RunSpec};

/// A folding step ladder on a smooth floor, its feet tied together, somebody on its top.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AC, mass = m, length = l)] // two one-letter points;
#[bar(CB, mass = m, length = l)] // the one they share is a hinge
#[mass(C, p)]
#[thread(AB, length = s)]
#[support(A = floor)]
#[support(B = floor)]
#[support(C = floor, restitution = 0.4)]
#[figure(A = (-s / 2, 0), C = (0, sqrt(l * l - s * s / 4)))]
#[coordinate(phi = angle(AC), from = horizontal)]
#[mirror(x = 0)] // B moves as the image of A
struct StepLadder {
    /// Mass of a leg, kg
    m: f64,
    /// Mass on the top, kg
    p: f64,
    /// Length of a leg, m
    l: f64,
    /// Length of the tie, m
    s: f64,
    /// Gravity, m/s²
    g: f64,
}

impl DefaultRun for StepLadder {
    fn default_run() -> RunSpec {
        let parameters = [("m", 4.0), ("p", 70.0), ("l", 2.0), ("s", 1.2), ("g", 9.81)];
        RunSpec::with(&parameters).cut("AB", "t = 0.5").limit(3.0)
    }
}

fn main() {
    liftoff_cli::run(liftoff_cli::models![StepLadder])
}
