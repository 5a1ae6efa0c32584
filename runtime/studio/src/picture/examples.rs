//! Small motions for tests.

use crate::models;
use crate::run_spec::RunSpec;
use liftoff::Trajectory;
use liftoff::prelude::*;

/// A ladder slides down a wall and leaves it.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Ladder {
    m: f64,
    l: f64,
    g: f64,
}

/// A ball bounces.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Ball {
    m: f64,
    g: f64,
    e: f64,
}

pub(super) fn ladder() -> Trajectory {
    let parameters = [("m", 1.0), ("l", 1.0), ("g", 9.81)];
    let spec = RunSpec::with(&parameters).start(&[("phi", 1.3)]).until("phi = 0");
    models![Ladder].find("ladder").unwrap().run(&spec).unwrap()
}

/// Dropped from a metre, g = 8 m/s²: it strikes the floor at ½ s with 4 m/s and leaves it with 2
/// m/s.
pub(super) fn ball() -> Trajectory {
    let parameters = [("m", 1.0), ("g", 8.0), ("e", 0.5)];
    let spec = RunSpec::with(&parameters).start(&[("x", 0.0), ("y", 1.0), ("x'", 1.0)]).until("t = 2");
    models![Ball].find("ball").unwrap().run(&spec).unwrap()
}
