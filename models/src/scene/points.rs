//! Point masses.

use crate::{BouncingBall, Looping, Marble, SpringPendulum};
use liftoff::scene::{Scene, Setup};

impl Scene for BouncingBall {
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("g", 9.81), ("e", 0.8)];
        Setup::with(&parameters).start(&[("y", 1.0), ("x", 0.0)]).until("t = 5")
    }
}

impl Scene for SpringPendulum {
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("k", 100.0), ("l", 1.0), ("c", 0.5), ("g", 9.81)];
        Setup::with(&parameters).start(&[("x", 0.5), ("y", 1.0)]).until("t = 5")
    }
}

impl Scene for Marble {
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("r", 1.0), ("g", 9.81)];
        let start = [("x", 1e-2)];
        Setup::with(&parameters).start(&start).energy_of(&[("x", 0.0)]).until("y = 0")
    }
}

impl Scene for Looping {
    fn setup() -> Setup {
        let parameters = [("m", 1.0), ("r", 1.0), ("g", 9.81)];
        let start = [("x", 0.0), ("x'", 6.0)];
        Setup::with(&parameters).start(&start).until("t = 2")
    }
}
