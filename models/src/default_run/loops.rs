//! Closed loops.

use super::ONE;
use crate::{CarAxis, NFourBar, Parallelogram, QuickReturn, SliderCrank, Squeezer};
use liftoff_studio::{DefaultRun, RunSpec};

impl DefaultRun for Parallelogram {
    fn default_run() -> RunSpec {
        let parameters = [("m", 1.0), ("l", 1.0), ("c", 1.0), ("d", 2.0), ("g", 9.81)];
        RunSpec::with(&parameters).start(&[("phi", 1.0)]).until("t = 5")
    }
}

impl DefaultRun for NFourBar {
    fn default_run() -> RunSpec {
        let start = [("phi", 0.0), ("phi'", 1.0)];
        RunSpec::with(&ONE).start(&start).until("t = 10")
    }
}

impl DefaultRun for SliderCrank {
    fn default_run() -> RunSpec {
        let parameters = [("a", 1.0), ("b", 0.5), ("c", 2.0), ("r", 0.1), ("l", 0.3), ("omega", 10.0)];
        RunSpec::with(&parameters).until("t = 1")
    }
}

impl DefaultRun for QuickReturn {
    fn default_run() -> RunSpec {
        let parameters = [("a", 1.0), ("b", 2.0), ("r", 0.2), ("l", 1.0), ("h", 0.5), ("omega", 5.0)];
        RunSpec::with(&parameters).until("t = 2")
    }
}

impl DefaultRun for Squeezer {
    fn default_run() -> RunSpec {
        RunSpec::with(&[("torque", 0.033), ("k", 4530.0)]).start(&[("theta", 0.0)]).until("t = 0.03")
    }
}

impl DefaultRun for CarAxis {
    fn default_run() -> RunSpec {
        let parameters =
            [("m", 10.0), ("l", 1.0), ("h", 0.5), ("k", 1e4), ("r", 0.1), ("omega", 10.0), ("g", 1.0)];
        RunSpec::with(&parameters).until("t = 3")
    }
}
