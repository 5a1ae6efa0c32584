//! Point masses.

use super::DefaultRun;
use liftoff_studio::RunSpec;

pub(super) const RUNS: &[DefaultRun] = &[
    ("bouncing-ball", bouncing_ball),
    ("spring-pendulum", spring_pendulum),
    ("marble", marble),
    ("looping", looping),
];

fn bouncing_ball() -> RunSpec {
    let parameters = [("m", 1.0), ("g", 9.81), ("e", 0.8)];
    RunSpec::with(&parameters).start(&[("y", 1.0), ("x", 0.0)]).until("t = 5")
}

fn spring_pendulum() -> RunSpec {
    let parameters = [("m", 1.0), ("k", 100.0), ("l", 1.0), ("c", 0.5), ("g", 9.81)];
    RunSpec::with(&parameters).start(&[("x", 0.5), ("y", 1.0)]).until("t = 5")
}

fn marble() -> RunSpec {
    let parameters = [("m", 1.0), ("r", 1.0), ("g", 9.81)];
    let start = [("x", 1e-2)];
    RunSpec::with(&parameters).start(&start).energy_of(&[("x", 0.0)]).until("y = 0")
}

fn looping() -> RunSpec {
    let parameters = [("m", 1.0), ("r", 1.0), ("g", 9.81)];
    let start = [("x", 0.0), ("x'", 6.0)];
    RunSpec::with(&parameters).start(&start).until("t = 2")
}
