//! Several bars without a loop.

use super::{ONE, Scene, Setup};
use crate::{AFrame, DoublePendulum, FoldedChain, StruckChain, UnequalPendulum, Walker};
use std::f64::consts::{FRAC_PI_2, PI};

impl Scene for AFrame {
    const NAME: &'static str = "a-frame";
    const SUMMARY: &'static str = "two hinged bars slide apart on a smooth floor, mirrored";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 80.0 * PI / 180.0)]).until("phi = 0")
    }
}

impl Scene for DoublePendulum {
    const NAME: &'static str = "double-pendulum";
    const SUMMARY: &'static str = "two bars hinged one to the other";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi_1", 0.0), ("phi_2", PI - 0.1)]).until("t = 10")
    }
}

impl Scene for UnequalPendulum {
    const NAME: &'static str = "unequal-pendulum";
    const SUMMARY: &'static str = "two bars of different masses hinged one to the other";
    fn setup() -> Setup {
        let parameters = [("m1", 1.0), ("m2", 3.0), ("l", 1.0), ("g", 9.81)];
        Setup::with(&parameters).start(&[("phi_1", 1.0), ("phi_2", 0.5)]).until("t = 10")
    }
}

impl Scene for StruckChain {
    const NAME: &'static str = "struck-chain";
    const SUMMARY: &'static str = "two hinged bars on a table, struck at an end";
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("l", 1.0)];
        Setup::with(&parameters).impulse("C", [0.0, 1.0], 0.5).until("t = 2")
    }
}

impl Scene for FoldedChain {
    const NAME: &'static str = "folded-chain";
    const SUMMARY: &'static str = "a folded chain of nine bars falls, one end held";
    fn setup() -> Setup {
        let angles = [0.0, 0.0, 0.0, 0.0, FRAC_PI_2, PI, PI, PI, PI];
        let parameters = [("m", 1.0), ("l", 1.0 / 9.0), ("g", 9.81)];
        let start = (1..).map(|k| format!("phi_{k}")).zip(angles).collect();
        Setup { start, ..Setup::with(&parameters).until("t = 0.6") }
    }
}

impl Scene for Walker {
    const NAME: &'static str = "walker";
    const SUMMARY: &'static str = "a walking frame with springs at hips and knees stands";
    fn setup() -> Setup {
        let parameters =
            [("m", 10.0), ("l", 1.0), ("a", 0.75_f64.atan()), ("k", 400.0), ("c", 20.0), ("g", 9.81)];
        Setup::with(&parameters).until("t = 2")
    }
}
