//! A phase's own equations, in the coordinates that it leaves free, against the full equations with multipliers.

use super::{Effort, Pair, at, case, runs, same};
use crate::catalog::{Failure, Model, Way};
use crate::model::Form;
use crate::stability::{Answer, Case, at_most};

const TOLERANCE: f64 = 1e-12;
/// Tolerances by which times and the last state may be off.
const MOST: f64 = 1e4;

pub(super) fn cases(model: &'static dyn Model, _: Effort) -> Vec<Case> {
    if model.layout().closed_forms.is_empty() || !runs(model) {
        return Vec::new();
    }
    let wants = vec![at_most("Δ times", MOST * TOLERANCE), at_most("Δ state", MOST * TOLERANCE)];
    let scene = format!("default run at {TOLERANCE:e} with multipliers, against closed forms");
    vec![case("forms", (model, ""), scene, "other equations", same(wants), move || compared(model))]
}

fn compared(model: &dyn Model) -> Result<Answer, Failure> {
    let setup = at(model, TOLERANCE);
    let pair = Pair { model, natural: model.units(&setup)?, units: [1.0; 3] };
    let projected = Way { form: Form::Projected, ..Way::default() };
    let other = model.run_by(projected, &setup)?;
    Ok(pair.compare(&*model.run(&setup)?, &*other))
}
