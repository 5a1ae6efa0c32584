//! Taylor's method as a method.

use super::{Dop853, Method, Problem, StartedStepper};

/// Taylor's method of variable order, [`crate::integrate::Taylor`], for the phases that have
/// series, in closed form or of the full equations without sliding contacts; DOP853 for the others.
#[derive(Debug, Clone, Copy, Default)]
pub struct Taylor;

impl Method for Taylor {
    fn name(&self) -> &'static str {
        "taylor"
    }

    fn takes_series(&self) -> bool {
        true
    }

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        match problem.start_taylor() {
            Some(stepper) => Some(StartedStepper::asked(self, stepper)),
            None => Dop853.begin(problem).map(|begun| begun.because("the phase has no Taylor series")),
        }
    }
}
