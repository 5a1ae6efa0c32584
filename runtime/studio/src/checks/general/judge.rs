//! Compares the default run with an independent judge, which uses the declaration alone, maximal
//! coordinates, double-double arithmetic and its own contact decisions.

use super::{Effort, TIGHT, case, runs, with_tolerance};
use crate::checks::{Answer, Case, Expected, at_most};
use crate::registry::{Entry, MethodId, MotionError, stopped};
use liftoff_verification::judgement::{Verdict, judge, witness_judged};

/// Bound in natural units, far above the error of a run at the tight tolerance.
const MOST: f64 = 1e-7;
/// Answer for a motion that the judge cannot compute.
const EXCUSE: &str = "not judged";

pub(super) fn cases(model: &'static Entry, _: Effort) -> Vec<Case> {
    if !runs(model) {
        return Vec::new();
    }
    let expected = Expected::Unless {
        text: "agrees".to_owned(),
        expectations: vec![at_most("apart", MOST)],
        excuse: EXCUSE,
    };
    let scene = format!("default run at {TIGHT:e}");
    vec![case("judge", (model, ""), scene, "judge", expected, move || judged(model))]
}

fn judged(model: &Entry) -> Result<Answer, MotionError> {
    let simulation = model.simulation(&with_tolerance(model, TIGHT))?.method(MethodId::Auto);
    let run = simulation.run().map_err(stopped)?;
    let verdict = judge(&run, &simulation.held());
    witness_judged(&run, verdict.clone());
    match verdict {
        Verdict::Agrees { error } => Ok(Answer { text: "agrees".to_owned(), numbers: vec![error] }),
        Verdict::Disagrees { t, what } => {
            Ok(Answer { text: format!("disagrees at t = {t}: {what}"), numbers: Vec::new() })
        }
        verdict @ Verdict::NotJudged { .. } => Err(MotionError::Input(verdict.to_string())),
    }
}
