//! Default runs from an equilibrium: nothing moves, and there is nothing to judge.

use super::{Effort, case, has_default_run, rests};
use crate::checks::{Answer, Case, Expected};
use crate::registry::Entry;

const EXCUSE: &str = "the start is an equilibrium";

pub(super) fn cases(model: &'static Entry, _: Effort) -> Vec<Case> {
    if !has_default_run(model) || !rests(model) {
        return Vec::new();
    }
    let expected = Expected::Unless { text: "moves".to_owned(), expectations: Vec::new(), excuse: EXCUSE };
    let measure = move || {
        model.run(&model.default_run()).map(|_| Answer { text: "moves".to_owned(), numbers: Vec::new() })
    };
    vec![case("motion", (model, ""), "default run".to_owned(), "mechanics", expected, measure)]
}
