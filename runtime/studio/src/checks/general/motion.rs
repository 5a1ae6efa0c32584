//! Default runs from an equilibrium: nothing moves, and there is nothing to judge.

use super::{Effort, case, has_default_run, rests};
use crate::checks::{Case, Expected};
use crate::registry::{Entry, input};
use liftoff::StartError;

const EXCUSE: &str = "the start is an equilibrium";

pub(super) fn cases(model: &'static Entry, _: Effort) -> Vec<Case> {
    if !has_default_run(model) || !rests(model) {
        return Vec::new();
    }
    let expected = Expected::Unless { text: "moves".to_owned(), expectations: Vec::new(), excuse: EXCUSE };
    let measure = || Err(input(StartError::Equilibrium));
    vec![case("motion", (model, ""), "default run".to_owned(), "mechanics", expected, measure)]
}
