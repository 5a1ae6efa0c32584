//! One bar or body.

use super::{ONE, Scene, Setup};
use crate::{BouncingBar, Chimney, Ladder, Pendulum, RockingBlock, RodOnFloor, RodOnThree, TopplingRod};
use std::f64::consts::{FRAC_PI_2, PI};

impl Scene for Ladder {
    const NAME: &'static str = "ladder";
    const SUMMARY: &'static str = "a bar slides down a smooth wall onto a smooth floor";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 75.0 * PI / 180.0)]).until("phi = 0")
    }
}

impl Scene for RodOnFloor {
    const NAME: &'static str = "rod-on-floor";
    const SUMMARY: &'static str = "a bar topples on a smooth floor";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 1e-2)]).until("phi = pi/2")
    }
}

impl Scene for TopplingRod {
    const NAME: &'static str = "toppling-rod";
    const SUMMARY: &'static str = "a rod topples about a rough point";
    fn setup() -> Setup {
        let upright = [("phi", 0.0)];
        Setup::with(&ONE).start(&[("phi", 1e-2)]).energy_of(&upright).until("phi = pi/2")
    }
}

impl Scene for Pendulum {
    const NAME: &'static str = "pendulum";
    const SUMMARY: &'static str = "a hinged bar";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", FRAC_PI_2)]).until("t = 10")
    }
}

impl Scene for Chimney {
    const NAME: &'static str = "chimney";
    const SUMMARY: &'static str = "a chimney falls; its internal forces";
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("l", 1.0), ("s", 1.0 / 3.0), ("g", 9.81)];
        Setup::with(&parameters).start(&[("phi", 0.1)]).until("phi = pi/2")
    }
}

impl Scene for BouncingBar {
    const NAME: &'static str = "bouncing-bar";
    const SUMMARY: &'static str = "a bar falls on a smooth floor and rebounds";
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("l", 1.0), ("g", 9.81), ("e", 0.5)];
        let start = [("phi", 0.5), ("y", 1.0), ("x", 0.0)];
        Setup::with(&parameters).start(&start).until("t = 2")
    }
}

impl Scene for RockingBlock {
    const NAME: &'static str = "rocking-block";
    const SUMMARY: &'static str = "Housner's block rocks on its rough corners";
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("b", 0.2), ("h", 1.0), ("g", 9.81)];
        Setup::with(&parameters).start(&[("phi", 0.1)]).until("t = 5")
    }
}

impl Scene for RodOnThree {
    const NAME: &'static str = "rod-on-three";
    const SUMMARY: &'static str = "a level rod on three supports, one of which vanishes";
    fn setup() -> Setup {
        Setup::with(&ONE).release("C", 0.5).until("t = 1")
    }
}
