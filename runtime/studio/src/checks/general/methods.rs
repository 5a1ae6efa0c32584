//! Every method finds the same events as the product's choice does at a tight tolerance, at the
//! same times.

use super::{Effort, Pair, TIGHT, case, runs, same, shown, with_tolerance};
use crate::checks::{Answer, Case};
use crate::registry::{Entry, MethodId, MotionError, RunOptions};

const TOLERANCE: f64 = 1e-9;
/// Tolerances by which times, the last state and reactions may be off.
const MOST: f64 = 1e4;

pub(super) fn cases(model: &'static Entry, _: Effort) -> Vec<Case> {
    if !runs(model) {
        return Vec::new();
    }
    let others = MethodId::ALL.into_iter().filter(|method| *method != MethodId::Auto);
    let one = |method: MethodId| {
        let scene = format!("default run at {TOLERANCE:e}, against auto at {TIGHT:e}");
        let measure = move || compared(model, method);
        let expected = same(model, MOST * TOLERANCE);
        let mut case = case("methods", (model, method.name()), scene, "another method", expected, measure);
        case.method = method;
        case
    };
    others.map(one).collect()
}

fn compared(model: &Entry, method: MethodId) -> Result<Answer, MotionError> {
    let spec = with_tolerance(model, TOLERANCE);
    let pair = Pair { model, natural: model.units(&spec)?, units: [1.0; 3] };
    let other = shown(&spec, model.run_by(RunOptions::by(method), &spec)?);
    Ok(pair.compare(&model.run(&with_tolerance(model, TIGHT))?, &other))
}
