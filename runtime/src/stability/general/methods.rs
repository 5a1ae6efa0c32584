//! Every method finds the same events as the product's choice does at a tight tolerance, at the same times.

use super::{Effort, Pair, TIGHT, at, case, runs, same};
use crate::catalog::{Failure, Integrator, Model, Way};
use crate::stability::{Answer, Case, at_most};

const TOLERANCE: f64 = 1e-9;
/// Tolerances by which times and the last state may be off.
const MOST: f64 = 1e4;

pub(super) fn cases(model: &'static dyn Model, _: Effort) -> Vec<Case> {
    if !runs(model) {
        return Vec::new();
    }
    let others = Integrator::ALL.into_iter().filter(|method| *method != Integrator::Auto);
    let one = |method: Integrator| {
        let wants = vec![at_most("Δ times", MOST * TOLERANCE), at_most("Δ state", MOST * TOLERANCE)];
        let scene = format!("default run at {TOLERANCE:e}, against auto at {TIGHT:e}");
        let measure = move || compared(model, method);
        let case = case("methods", (model, method.name()), scene, "another method", same(wants), measure);
        Case { method, ..case }
    };
    others.map(one).collect()
}

fn compared(model: &dyn Model, method: Integrator) -> Result<Answer, Failure> {
    let setup = at(model, TOLERANCE);
    let pair = Pair { model, natural: model.units(&setup)?, units: [1.0; 3] };
    let other = model.run_by(Way::by(method), &setup)?;
    Ok(pair.compare(&*model.run(&at(model, TIGHT))?, &*other))
}
