//! Point masses.

use crate::{BouncingBall, Looping, Marble, SpringPendulum};
use liftoff_studio::{DefaultRun, RunSpec};

impl DefaultRun for BouncingBall {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("g", 9.81), ("e", 0.8)];
        RunSpec::with(&parameters).start(&[("y", 1.0), ("x", 0.0)]).until("t = 5")
    }
}

impl DefaultRun for SpringPendulum {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("k", 100.0), ("l", 1.0), ("c", 0.5), ("g", 9.81)];
        RunSpec::with(&parameters).start(&[("x", 0.5), ("y", 1.0)]).until("t = 5")
    }
}

impl DefaultRun for Marble {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("r", 1.0), ("g", 9.81)];
        let start = [("x", 1e-2)];
        RunSpec::with(&parameters).start(&start).energy_of(&[("x", 0.0)]).until("y = 0")
    }
}

impl DefaultRun for Looping {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("r", 1.0), ("g", 9.81)];
        let start = [("x", 0.0), ("x'", 6.0)];
        RunSpec::with(&parameters).start(&start).until("t = 2")
    }
}
