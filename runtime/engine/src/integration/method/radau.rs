//! Radau IIA as a method, with the exact Jacobian of the phase.

use super::{Dop853, Method, Problem, StartedStepper};
use crate::integrate::erased;

/// Radau IIA of order 5, for stiff springs and dampers: [`crate::integrate::Radau`]; DOP853 for phases whose Jacobian is not
/// known, or larger than 64 by 64.
#[derive(Debug, Clone, Copy, Default)]
pub struct Radau;

impl Method for Radau {
    fn name(&self) -> &'static str {
        "radau"
    }

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        match erased::radau(&problem.problem) {
            Some(stepper) => Some(StartedStepper::asked(self, stepper)),
            None => {
                Dop853.begin(problem).map(|begun| begun.because("its Jacobian is not known, or too large"))
            }
        }
    }
}
