//! The systems of the paper.

use super::ONE;
use crate::{FallingPair, FallingPairFull, NarrowGap, Zigzag, ZigzagFull, ZigzagPublished, ZigzagThread};
use liftoff::scene::{Scene, Setup};
use std::f64::consts::FRAC_PI_2;

const HALVES: [(&str, f64); 4] = [("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("g", 9.81)];

impl Scene for FallingPair {
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 1e-2)]).energy_of(&[("phi", 0.0)]).until("phi = pi/2")
    }
}

impl Scene for FallingPairFull {
    fn setup() -> Setup {
        let start = [("phi_left", 0.1), ("phi_right", 0.1)];
        Setup::with(&ONE).start(&start).until("phi_left = pi/2").until("phi_right = pi/2")
    }
}

impl Scene for NarrowGap {
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("l", 1.0), ("w", 0.02), ("g", 9.81)];
        Setup::with(&parameters).start(&[("phi", 0.5), ("phi'", 9.0)]).hold(&["P"]).until("t = 0.5")
    }
}

impl Scene for ZigzagPublished {
    fn setup() -> Setup {
        Setup::with(&HALVES).start(&[("phi", 1.56)]).energy_of(&[("phi", FRAC_PI_2)])
    }
}

impl Scene for Zigzag {
    fn setup() -> Setup {
        let upright = [("phi_inner", FRAC_PI_2), ("phi_outer", FRAC_PI_2), ("y", 0.0)];
        Setup::with(&HALVES).start(&[("phi_inner", 1.56), ("phi_outer", 1.56)]).energy_of(&upright)
    }
}

impl Scene for ZigzagFull {
    fn setup() -> Setup {
        let start = [("phi_ab", 1.5), ("phi_bc", 1.5), ("phi_cd", 1.5), ("phi_de", 1.5)];
        Setup::with(&HALVES).start(&start)
    }
}

impl Scene for ZigzagThread {
    fn setup() -> Setup {
        let parameters = [("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("s", 0.6), ("g", 9.81)];
        let phi = 0.3_f64.acos();
        Setup::with(&parameters).start(&[("phi_inner", phi), ("phi_outer", phi)]).cut("BD", "t = 0.5")
    }
}
