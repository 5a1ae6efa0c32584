//! Closed loops.

use super::{ONE, Scene, Setup};
use crate::{NFourBar, Parallelogram, QuickReturn, SliderCrank, Squeezer};

impl Scene for Parallelogram {
    const NAME: &'static str = "parallelogram";
    const SUMMARY: &'static str = "a bar hangs from two equal cranks";
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("l", 1.0), ("c", 1.0), ("d", 2.0), ("g", 9.81)];
        Setup::with(&parameters).start(&[("phi", 1.0)]).until("t = 5")
    }
}

impl Scene for NFourBar {
    const NAME: &'static str = "n-four-bar";
    const SUMMARY: &'static str = "two four-bar loops in a row, singular twice a turn";
    fn setup() -> Setup {
        let start = [("phi", 0.0), ("phi'", 1.0)];
        Setup::with(&ONE).start(&start).until("t = 10")
    }
}

impl Scene for SliderCrank {
    const NAME: &'static str = "slider-crank";
    const SUMMARY: &'static str = "a steadily driven crank moves a piston";
    fn setup() -> Setup {
        let parameters = [("a", 1.0), ("b", 0.5), ("c", 2.0), ("r", 0.1), ("l", 0.3), ("omega", 10.0)];
        Setup::with(&parameters).until("t = 1")
    }
}

impl Scene for QuickReturn {
    const NAME: &'static str = "quick-return";
    const SUMMARY: &'static str = "a steady crank swings a slotted lever";
    fn setup() -> Setup {
        let parameters = [("a", 1.0), ("b", 2.0), ("r", 0.2), ("l", 1.0), ("h", 0.5), ("omega", 5.0)];
        Setup::with(&parameters).until("t = 2")
    }
}

impl Scene for Squeezer {
    const NAME: &'static str = "squeezer";
    const SUMMARY: &'static str = "Andrews' squeezer: seven bodies, three loops";
    fn setup() -> Setup {
        Setup::with(&[("torque", 0.033), ("k", 4530.0)]).start(&[("theta", 0.0)]).until("t = 0.03")
    }
}
