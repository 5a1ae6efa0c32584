//! The systems of the paper.

use super::{DefaultRun, ONE};
use liftoff_studio::RunSpec;
use std::f64::consts::FRAC_PI_2;

const HALVES: [(&str, f64); 4] = [("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("g", 9.81)];

pub(super) const RUNS: &[DefaultRun] = &[
    ("falling-pair", falling_pair),
    ("falling-pair-full", falling_pair_full),
    ("narrow-gap", narrow_gap),
    ("zigzag-published", zigzag_published),
    ("zigzag", zigzag),
    ("zigzag-full", zigzag_full),
    ("zigzag-thread", zigzag_thread),
];

fn falling_pair() -> RunSpec {
    RunSpec::with(&ONE).start(&[("phi", 1e-2)]).energy_of(&[("phi", 0.0)]).until("phi = pi/2")
}

fn falling_pair_full() -> RunSpec {
    let start = [("phi_left", 0.1), ("phi_right", 0.1)];
    RunSpec::with(&ONE).start(&start).until("phi_left = pi/2").until("phi_right = pi/2")
}

fn narrow_gap() -> RunSpec {
    let parameters = [("m", 1.0), ("l", 1.0), ("w", 0.02), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("phi", 0.5), ("phi'", 9.0)]).hold(&["P"]).until("t = 0.5")
}

fn zigzag_published() -> RunSpec {
    RunSpec::with(&HALVES).start(&[("phi", 1.56)]).energy_of(&[("phi", FRAC_PI_2)])
}

fn zigzag() -> RunSpec {
    let upright = [("phi_inner", FRAC_PI_2), ("phi_outer", FRAC_PI_2), ("y", 0.0)];
    RunSpec::with(&HALVES).start(&[("phi_inner", 1.56), ("phi_outer", 1.56)]).energy_of(&upright)
}

fn zigzag_full() -> RunSpec {
    let start = [("phi_ab", 1.5), ("phi_bc", 1.5), ("phi_cd", 1.5), ("phi_de", 1.5)];
    RunSpec::with(&HALVES).start(&start)
}

fn zigzag_thread() -> RunSpec {
    let parameters = [("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("s", 0.6), ("g", 9.81)];
    let phi = 0.3_f64.acos();
    RunSpec::with(&parameters).start(&[("phi_inner", phi), ("phi_outer", phi)]).cut("BD", "t = 0.5")
}
