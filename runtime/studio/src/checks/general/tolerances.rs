//! Errors of the last state and of event times against the same motion in double-double, by a
//! method that has no part in the run: in tolerances they are as large as the errors of some
//! hundred steps together, grown by the motion's own sensitivity.

use super::{Effort, case, runs};
use crate::checks::{Answer, Case, Expected, at_most};
use crate::registry::{Entry, MethodId, MotionError, PrecisionSpec};
use std::time::Duration;

const TOLERANCES: [f64; 3] = [1e-6, 1e-9, 1e-12];
/// Tolerances that errors may come to.
const MOST: f64 = 1e3;
/// Of a model whose motion leaves nothing to compare with.
const EXCUSE: &str = "no reference";

pub(super) fn cases(model: &'static Entry, _: Effort) -> Vec<Case> {
    if !runs(model) {
        return Vec::new();
    }
    let expectations = ["state at 1e-6", "times", "state at 1e-9", "times", "state at 1e-12", "times"];
    let within = TOLERANCES.into_iter().flat_map(|tolerance| [MOST * tolerance; 2]);
    let expectations =
        expectations.into_iter().zip(within).map(|(name, within)| at_most(name, within)).collect();
    let expected = Expected::Unless { text: String::new(), expectations, excuse: EXCUSE };
    let scene = "default run, error at tolerances 1e-6, 1e-9 and 1e-12".to_owned();
    vec![case("tolerances", (model, ""), scene, "double-double", expected, move || errors(model))]
}

fn errors(model: &Entry) -> Result<Answer, MotionError> {
    let request = PrecisionSpec {
        methods: vec![MethodId::Auto],
        tolerances: TOLERANCES.to_vec(),
        measuring: Duration::ZERO,
    };
    let mut numbers = Vec::new();
    for row in model.precision(&model.default_run(), &request)? {
        if let Some(reason) = row.reason {
            return Err(MotionError::Input(reason));
        }
        numbers.extend([row.state_error, row.event_error].map(|error| error.unwrap_or(f64::NAN)));
    }
    Ok(Answer { text: String::new(), numbers })
}
