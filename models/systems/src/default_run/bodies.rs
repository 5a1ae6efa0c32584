//! Bodies that strike bodies, and what walks and throws.

use super::DefaultRun;
use liftoff_studio::RunSpec;
use std::f64::consts::PI;

pub(super) const RUNS: &[DefaultRun] = &[
    ("newtons-cradle", newtons_cradle),
    ("dominoes", dominoes),
    ("compass-walker", compass_walker),
    ("trebuchet", trebuchet),
    ("jansen-leg", jansen_leg),
    ("balance-wheel", balance_wheel),
];

fn newtons_cradle() -> RunSpec {
    let parameters = [("m", 0.1), ("r", 0.02), ("l", 0.2), ("d", 1e-4), ("e", 1.0), ("g", 9.81)];
    let start = [("a", -0.5), ("b", 0.0), ("c", 0.0), ("f", 0.0), ("h", 0.0)];
    RunSpec::with(&parameters).start(&start).until("t = 2")
}

fn dominoes() -> RunSpec {
    let parameters = [("m", 0.01), ("w", 0.008), ("h", 0.048), ("s", 0.02), ("mu", 0.8), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("phi", -0.25)]).until("t = 0.6")
}

fn compass_walker() -> RunSpec {
    let masses = [("m", 5.0), ("hip", 10.0), ("j", 0.0), ("a", 0.5), ("b", 0.5)];
    let gamma = PI / 60.0;
    let place = [("gamma", gamma), ("s", 0.535), ("g", 9.8)];
    let parameters: Vec<(&str, f64)> = masses.into_iter().chain(place).collect();
    // Both feet on the slope, A at rest.
    let legs = [("left", 0.2187), ("right", -2.0 * gamma - 0.2187), ("left'", -1.0918), ("right'", -0.3772)];
    let foot = [("x", 0.0), ("y", 0.0), ("x'", 0.0), ("y'", 0.0)];
    let start: Vec<(&str, f64)> = legs.into_iter().chain(foot).collect();
    RunSpec::with(&parameters).start(&start).until("t = 5")
}

fn balance_wheel() -> RunSpec {
    let wheel = [("m", 1.0), ("inertia", 1.0), ("r", 1.0), ("k", 40.0), ("c", 0.4), ("push", 2.0)];
    RunSpec::with(&wheel).start(&[("phi", 0.1)]).until("t = 12")
}

fn trebuchet() -> RunSpec {
    let masses = [("m", 10.0), ("weight", 150.0), ("stone", 1.5)];
    let lengths = [("a", 0.4), ("b", 1.6), ("c", 0.4), ("s", 1.5)];
    let parameters: Vec<(&str, f64)> =
        masses.into_iter().chain(lengths).chain([("release", 3.12), ("g", 9.81)]).collect();
    RunSpec::with(&parameters).until("t = 0.62")
}

fn jansen_leg() -> RunSpec {
    let parameters = [("rho", 1.0), ("u", 0.01), ("omega", 2.0 * PI), ("g", 9.81)];
    RunSpec::with(&parameters).until("t = 2")
}
