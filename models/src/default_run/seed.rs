//! The systems of the paper.

use super::ONE;
use crate::{FallingPair, FallingPairFull, NarrowGap, Zigzag, ZigzagFull, ZigzagPublished, ZigzagThread};
use liftoff_studio::{DefaultRun, RunSpec};
use std::f64::consts::FRAC_PI_2;

const HALVES: [(&str, f64); 4] = [("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("g", 9.81)];

impl DefaultRun for FallingPair {
    fn default_run() -> RunSpec {
        RunSpec::with(&ONE).start(&[("phi", 1e-2)]).energy_of(&[("phi", 0.0)]).until("phi = pi/2")
    }
}

impl DefaultRun for FallingPairFull {
    fn default_run() -> RunSpec {
        let start = [("phi_left", 0.1), ("phi_right", 0.1)];
        RunSpec::with(&ONE).start(&start).until("phi_left = pi/2").until("phi_right = pi/2")
    }
}

impl DefaultRun for NarrowGap {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("l", 1.0), ("w", 0.02), ("g", 9.81)];
        RunSpec::with(&parameters).start(&[("phi", 0.5), ("phi'", 9.0)]).hold(&["P"]).until("t = 0.5")
    }
}

impl DefaultRun for ZigzagPublished {
    fn default_run() -> RunSpec {
        RunSpec::with(&HALVES).start(&[("phi", 1.56)]).energy_of(&[("phi", FRAC_PI_2)])
    }
}

impl DefaultRun for Zigzag {
    fn default_run() -> RunSpec {
        let upright = [("phi_inner", FRAC_PI_2), ("phi_outer", FRAC_PI_2), ("y", 0.0)];
        RunSpec::with(&HALVES).start(&[("phi_inner", 1.56), ("phi_outer", 1.56)]).energy_of(&upright)
    }
}

impl DefaultRun for ZigzagFull {
    fn default_run() -> RunSpec {
        let start = [("phi_ab", 1.5), ("phi_bc", 1.5), ("phi_cd", 1.5), ("phi_de", 1.5)];
        RunSpec::with(&HALVES).start(&start)
    }
}

impl DefaultRun for ZigzagThread {
    fn default_run() -> RunSpec {
        let parameters = [("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("s", 0.6), ("g", 9.81)];
        let phi = 0.3_f64.acos();
        RunSpec::with(&parameters).start(&[("phi_inner", phi), ("phi_outer", phi)]).cut("BD", "t = 0.5")
    }
}
