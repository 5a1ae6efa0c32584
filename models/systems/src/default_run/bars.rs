//! One bar or body.

use super::{DefaultRun, ONE};
use liftoff_studio::RunSpec;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const RUNS: &[DefaultRun] = &[
    ("ladder", ladder),
    ("rod-on-floor", rod_on_floor),
    ("toppling-rod", toppling_rod),
    ("pendulum", pendulum),
    ("chimney", chimney),
    ("bouncing-bar", bouncing_bar),
    ("rocking-block", rocking_block),
    ("rod-on-three", rod_on_three),
];

fn ladder() -> RunSpec {
    RunSpec::with(&ONE).start(&[("phi", 75.0 * PI / 180.0)]).until("phi = 0")
}

fn rod_on_floor() -> RunSpec {
    RunSpec::with(&ONE).start(&[("phi", 1e-2)]).until("phi = pi/2")
}

fn toppling_rod() -> RunSpec {
    let upright = [("phi", 0.0)];
    RunSpec::with(&ONE).start(&[("phi", 1e-2)]).energy_of(&upright).until("phi = pi/2")
}

fn pendulum() -> RunSpec {
    RunSpec::with(&ONE).start(&[("phi", FRAC_PI_2)]).until("t = 10")
}

fn chimney() -> RunSpec {
    let parameters = [("m", 1.0), ("l", 1.0), ("s", 1.0 / 3.0), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("phi", 0.1)]).until("phi = pi/2")
}

fn bouncing_bar() -> RunSpec {
    let parameters = [("m", 1.0), ("l", 1.0), ("g", 9.81), ("e", 0.5)];
    let start = [("phi", 0.5), ("y", 1.0), ("x", 0.0)];
    RunSpec::with(&parameters).start(&start).until("t = 2")
}

fn rocking_block() -> RunSpec {
    let parameters = [("m", 1.0), ("b", 0.2), ("h", 1.0), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("phi", 0.1)]).until("t = 5")
}

fn rod_on_three() -> RunSpec {
    RunSpec::with(&ONE).release("C", 0.5).until("t = 1")
}
