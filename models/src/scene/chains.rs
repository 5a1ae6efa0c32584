//! Several bars without a loop.

use super::ONE;
use crate::{AFrame, DoublePendulum, FoldedChain, StruckChain, UnequalPendulum, Walker};
use liftoff::scene::{Scene, Setup};
use std::f64::consts::{FRAC_PI_2, PI};

impl Scene for AFrame {
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 80.0 * PI / 180.0)]).until("phi = 0")
    }
}

impl Scene for DoublePendulum {
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi_1", 0.0), ("phi_2", PI - 0.1)]).until("t = 10")
    }
}

impl Scene for UnequalPendulum {
    fn setup() -> Setup {
        let parameters = [("m1", 1.0), ("m2", 3.0), ("l", 1.0), ("g", 9.81)];
        Setup::with(&parameters).start(&[("phi_1", 1.0), ("phi_2", 0.5)]).until("t = 10")
    }
}

impl Scene for StruckChain {
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("l", 1.0)];
        Setup::with(&parameters).impulse("C", [0.0, 1.0], 0.5).until("t = 2")
    }
}

impl Scene for FoldedChain {
    fn setup() -> Setup {
        let angles = [0.0, 0.0, 0.0, 0.0, FRAC_PI_2, PI, PI, PI, PI];
        let parameters = [("m", 1.0), ("l", 1.0 / 9.0), ("g", 9.81)];
        let start = (1..).map(|k| format!("phi_{k}")).zip(angles).collect();
        Setup { start, ..Setup::with(&parameters).until("t = 0.6") }
    }
}

impl Scene for Walker {
    fn setup() -> Setup {
        let parameters =
            [("m", 10.0), ("l", 1.0), ("a", 0.75_f64.atan()), ("k", 400.0), ("c", 20.0), ("g", 9.81)];
        Setup::with(&parameters).until("t = 2")
    }
}
