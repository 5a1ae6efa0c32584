//! One bar or body.

use super::ONE;
use crate::{BouncingBar, Chimney, Ladder, Pendulum, RockingBlock, RodOnFloor, RodOnThree, TopplingRod};
use liftoff::scene::{Scene, Setup};
use std::f64::consts::{FRAC_PI_2, PI};

impl Scene for Ladder {
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 75.0 * PI / 180.0)]).until("phi = 0")
    }
}

impl Scene for RodOnFloor {
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 1e-2)]).until("phi = pi/2")
    }
}

impl Scene for TopplingRod {
    fn setup() -> Setup {
        let upright = [("phi", 0.0)];
        Setup::with(&ONE).start(&[("phi", 1e-2)]).energy_of(&upright).until("phi = pi/2")
    }
}

impl Scene for Pendulum {
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", FRAC_PI_2)]).until("t = 10")
    }
}

impl Scene for Chimney {
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("l", 1.0), ("s", 1.0 / 3.0), ("g", 9.81)];
        Setup::with(&parameters).start(&[("phi", 0.1)]).until("phi = pi/2")
    }
}

impl Scene for BouncingBar {
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("l", 1.0), ("g", 9.81), ("e", 0.5)];
        let start = [("phi", 0.5), ("y", 1.0), ("x", 0.0)];
        Setup::with(&parameters).start(&start).until("t = 2")
    }
}

impl Scene for RockingBlock {
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("b", 0.2), ("h", 1.0), ("g", 9.81)];
        Setup::with(&parameters).start(&[("phi", 0.1)]).until("t = 5")
    }
}

impl Scene for RodOnThree {
    fn setup() -> Setup {
        Setup::with(&ONE).release("C", 0.5).until("t = 1")
    }
}
