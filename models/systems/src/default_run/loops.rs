//! Closed loops.

use super::{DefaultRun, ONE};
use liftoff_studio::RunSpec;

pub(super) const RUNS: &[DefaultRun] = &[
    ("parallelogram", parallelogram),
    ("n-four-bar", n_four_bar),
    ("slider-crank", slider_crank),
    ("quick-return", quick_return),
    ("squeezer", squeezer),
    ("car-axis", car_axis),
];

fn parallelogram() -> RunSpec {
    let parameters = [("m", 1.0), ("l", 1.0), ("c", 1.0), ("d", 2.0), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("phi", 1.0)]).until("t = 5")
}

fn n_four_bar() -> RunSpec {
    let start = [("phi", 0.0), ("phi'", 1.0)];
    RunSpec::with(&ONE).start(&start).until("t = 10")
}

fn slider_crank() -> RunSpec {
    let parameters = [("a", 1.0), ("b", 0.5), ("c", 2.0), ("r", 0.1), ("l", 0.3), ("omega", 10.0)];
    RunSpec::with(&parameters).until("t = 1")
}

fn quick_return() -> RunSpec {
    let parameters = [("a", 1.0), ("b", 2.0), ("r", 0.2), ("l", 1.0), ("h", 0.5), ("omega", 5.0)];
    RunSpec::with(&parameters).until("t = 2")
}

fn squeezer() -> RunSpec {
    RunSpec::with(&[("torque", 0.033), ("k", 4530.0)]).start(&[("theta", 0.0)]).until("t = 0.03")
}

fn car_axis() -> RunSpec {
    let parameters =
        [("m", 10.0), ("l", 1.0), ("h", 0.5), ("k", 1e4), ("r", 0.1), ("omega", 10.0), ("g", 1.0)];
    RunSpec::with(&parameters).until("t = 3")
}
