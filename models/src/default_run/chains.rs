//! Several bars without a loop.

use super::ONE;
use crate::{AFrame, DoublePendulum, FoldedChain, StruckChain, UnequalPendulum, Walker};
use liftoff_studio::{DefaultRun, RunSpec};
use std::f64::consts::{FRAC_PI_2, PI};

impl DefaultRun for AFrame {
    fn default_run() -> RunSpec {
        RunSpec::with(&ONE).start(&[("phi", 80.0 * PI / 180.0)]).until("phi = 0")
    }
}

impl DefaultRun for DoublePendulum {
    fn default_run() -> RunSpec {
        RunSpec::with(&ONE).start(&[("phi_1", 0.0), ("phi_2", PI - 0.1)]).until("t = 10")
    }
}

impl DefaultRun for UnequalPendulum {
    fn default_run() -> RunSpec {
        let parameters = [("m1", 1.0), ("m2", 3.0), ("l", 1.0), ("g", 9.81)];
        RunSpec::with(&parameters).start(&[("phi_1", 1.0), ("phi_2", 0.5)]).until("t = 10")
    }
}

impl DefaultRun for StruckChain {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("l", 1.0)];
        RunSpec::with(&parameters).impulse("C", [0.0, 1.0], 0.5).until("t = 2")
    }
}

impl DefaultRun for FoldedChain {
    fn default_run() -> RunSpec {
        let angles = [0.0, 0.0, 0.0, 0.0, FRAC_PI_2, PI, PI, PI, PI];
        let parameters = [("m", 1.0), ("l", 1.0 / 9.0), ("g", 9.81)];
        let start = (1..).map(|k| format!("phi_{k}")).zip(angles).collect();
        RunSpec { start, ..RunSpec::with(&parameters).until("t = 0.6") }
    }
}

impl DefaultRun for Walker {
    fn default_run() -> RunSpec {
        let parameters =
            [("m", 10.0), ("l", 1.0), ("a", 0.75_f64.atan()), ("k", 400.0), ("c", 20.0), ("g", 9.81)];
        RunSpec::with(&parameters).until("t = 2")
    }
}
