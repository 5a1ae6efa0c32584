//! Several bars without a loop.

use super::{DefaultRun, ONE};
use liftoff_studio::RunSpec;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const RUNS: &[DefaultRun] = &[
    ("a-frame", a_frame),
    ("double-pendulum", double_pendulum),
    ("unequal-pendulum", unequal_pendulum),
    ("cart-pendulum", cart_pendulum),
    ("struck-chain", struck_chain),
    ("folded-chain", folded_chain),
    ("walker", walker),
];

fn a_frame() -> RunSpec {
    RunSpec::with(&ONE).start(&[("phi", 80.0 * PI / 180.0)]).until("phi = 0")
}

fn double_pendulum() -> RunSpec {
    RunSpec::with(&ONE).start(&[("phi_1", 0.0), ("phi_2", PI - 0.1)]).until("t = 10")
}

fn unequal_pendulum() -> RunSpec {
    let parameters = [("m1", 1.0), ("m2", 3.0), ("l", 1.0), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("phi_1", 1.0), ("phi_2", 0.5)]).until("t = 10")
}

fn cart_pendulum() -> RunSpec {
    let parameters = [("a", 2.0), ("m", 1.0), ("l", 1.0), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("phi", 1.0), ("x", 0.0)]).until("t = 5")
}

fn struck_chain() -> RunSpec {
    let parameters = [("m", 1.0), ("l", 1.0)];
    RunSpec::with(&parameters).impulse("C", [0.0, 1.0], 0.5).until("t = 2")
}

fn folded_chain() -> RunSpec {
    let angles = [0.0, 0.0, 0.0, 0.0, FRAC_PI_2, PI, PI, PI, PI];
    let parameters = [("m", 1.0), ("l", 1.0 / 9.0), ("g", 9.81)];
    let start = (1..).map(|k| format!("phi_{k}")).zip(angles).collect();
    RunSpec { start, ..RunSpec::with(&parameters).until("t = 0.6") }
}

fn walker() -> RunSpec {
    let parameters =
        [("m", 10.0), ("l", 1.0), ("a", 0.75_f64.atan()), ("k", 400.0), ("c", 20.0), ("g", 9.81)];
    RunSpec::with(&parameters).until("t = 2")
}
