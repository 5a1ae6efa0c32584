//! A phase's own equations, in the coordinates that it leaves free, against the full equations with
//! multipliers.

use super::{Effort, Pair, case, runs, same, shown, with_tolerance};
use crate::checks::{Answer, Case};
use crate::registry::{Entry, MotionError, RunOptions};
use liftoff_core::model::Form;

const TOLERANCE: f64 = 1e-12;
/// Tolerances by which times, the last state and reactions may be off.
const MOST: f64 = 1e4;

pub(super) fn cases(model: &'static Entry, _: Effort) -> Vec<Case> {
    if model.layout().closed_forms.is_empty() || !runs(model) {
        return Vec::new();
    }
    let scene = format!("default run at {TOLERANCE:e} with multipliers, against closed forms");
    vec![case("forms", (model, ""), scene, "other equations", same(model, MOST * TOLERANCE), move || {
        compared(model)
    })]
}

fn compared(model: &Entry) -> Result<Answer, MotionError> {
    let spec = with_tolerance(model, TOLERANCE);
    let pair = Pair { model, natural: model.units(&spec)?, units: [1.0; 3] };
    let projected = RunOptions { form: Form::Multipliers, ..RunOptions::default() };
    let other = shown(&spec, model.run_by(projected, &spec)?);
    Ok(pair.compare(&model.run(&spec)?, &other))
}
