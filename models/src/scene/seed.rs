//! The systems of the paper.

use super::{ONE, Scene, Setup};
use crate::{FallingPair, FallingPairFull, NarrowGap, Zigzag, ZigzagFull, ZigzagPublished, ZigzagThread};
use std::f64::consts::FRAC_PI_2;

const HALVES: [(&str, f64); 4] = [("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("g", 9.81)];

impl Scene for FallingPair {
    const NAME: &'static str = "falling-pair";
    const SUMMARY: &'static str = "two hinged bars fall through a gap (Fig. 1a), mirrored";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 1e-2)]).energy_of(&[("phi", 0.0)]).until("phi = pi/2")
    }
}

impl Scene for FallingPairFull {
    const NAME: &'static str = "falling-pair-full";
    const SUMMARY: &'static str = "two hinged bars fall through a gap, no symmetry assumed";
    fn setup() -> Setup {
        let start = [("phi_left", 0.1), ("phi_right", 0.1)];
        Setup::with(&ONE).start(&start).until("phi_left = pi/2").until("phi_right = pi/2")
    }
}

impl Scene for NarrowGap {
    const NAME: &'static str = "narrow-gap";
    const SUMMARY: &'static str = "two hinged bars turn nearly upright on the corners of a narrow gap";
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("l", 1.0), ("w", 0.02), ("g", 9.81)];
        Setup::with(&parameters).start(&[("phi", 0.5), ("phi'", 9.0)]).hold(&["P"]).until("t = 0.5")
    }
}

impl Scene for ZigzagPublished {
    const NAME: &'static str = "zigzag-published";
    const SUMMARY: &'static str = "four bars in the shape of an M (Fig. 1b), equal angles, total reaction";
    fn setup() -> Setup {
        Setup::with(&HALVES).start(&[("phi", 1.56)]).energy_of(&[("phi", FRAC_PI_2)])
    }
}

impl Scene for Zigzag {
    const NAME: &'static str = "zigzag";
    const SUMMARY: &'static str =
        "four bars in the shape of an M (Fig. 1b), every support on its own, mirrored";
    fn setup() -> Setup {
        let upright = [("phi_inner", FRAC_PI_2), ("phi_outer", FRAC_PI_2), ("y", 0.0)];
        Setup::with(&HALVES).start(&[("phi_inner", 1.56), ("phi_outer", 1.56)]).energy_of(&upright)
    }
}

impl Scene for ZigzagFull {
    const NAME: &'static str = "zigzag-full";
    const SUMMARY: &'static str = "four bars in the shape of an M, no symmetry assumed";
    fn setup() -> Setup {
        let start = [("phi_ab", 1.5), ("phi_bc", 1.5), ("phi_cd", 1.5), ("phi_de", 1.5)];
        Setup::with(&HALVES).start(&start)
    }
}

impl Scene for ZigzagThread {
    const NAME: &'static str = "zigzag-thread";
    const SUMMARY: &'static str = "four bars in the shape of an M (Fig. 1b), held by a thread that is cut";
    fn setup() -> Setup {
        let parameters = [("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("s", 0.6), ("g", 9.81)];
        let phi = 0.3_f64.acos();
        Setup::with(&parameters).start(&[("phi_inner", phi), ("phi_outer", phi)]).cut("BD", "t = 0.5")
    }
}
