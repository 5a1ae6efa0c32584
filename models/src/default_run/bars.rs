//! One bar or body.

use super::ONE;
use crate::{BouncingBar, Chimney, Ladder, Pendulum, RockingBlock, RodOnFloor, RodOnThree, TopplingRod};
use liftoff_studio::{DefaultRun, RunSpec};
use std::f64::consts::{FRAC_PI_2, PI};

impl DefaultRun for Ladder {
    fn default_run() -> RunSpec {
        RunSpec::with(&ONE).start(&[("phi", 75.0 * PI / 180.0)]).until("phi = 0")
    }
}

impl DefaultRun for RodOnFloor {
    fn default_run() -> RunSpec {
        RunSpec::with(&ONE).start(&[("phi", 1e-2)]).until("phi = pi/2")
    }
}

impl DefaultRun for TopplingRod {
    fn default_run() -> RunSpec {
        let upright = [("phi", 0.0)];
        RunSpec::with(&ONE).start(&[("phi", 1e-2)]).energy_of(&upright).until("phi = pi/2")
    }
}

impl DefaultRun for Pendulum {
    fn default_run() -> RunSpec {
        RunSpec::with(&ONE).start(&[("phi", FRAC_PI_2)]).until("t = 10")
    }
}

impl DefaultRun for Chimney {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("l", 1.0), ("s", 1.0 / 3.0), ("g", 9.81)];
        RunSpec::with(&parameters).start(&[("phi", 0.1)]).until("phi = pi/2")
    }
}

impl DefaultRun for BouncingBar {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("l", 1.0), ("g", 9.81), ("e", 0.5)];
        let start = [("phi", 0.5), ("y", 1.0), ("x", 0.0)];
        RunSpec::with(&parameters).start(&start).until("t = 2")
    }
}

impl DefaultRun for RockingBlock {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("b", 0.2), ("h", 1.0), ("g", 9.81)];
        RunSpec::with(&parameters).start(&[("phi", 0.1)]).until("t = 5")
    }
}

impl DefaultRun for RodOnThree {
    fn default_run() -> RunSpec {
        RunSpec::with(&ONE).release("C", 0.5).until("t = 1")
    }
}
