//! Radau IIA as a method, with the exact Jacobian of the phase where its equations can be stiff.

use super::{Dop853, Method, Problem, StartedStepper};
use crate::system::erased;

/// Radau IIA of order 5, for stiff springs and dampers: [`crate::integrate::Radau`]; DOP853 for
/// phases of more than 64 entries.
#[derive(Debug, Clone, Copy, Default)]
pub struct Radau;

impl Method for Radau {
    fn name(&self) -> &'static str {
        "radau"
    }

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        let start = erased::radau(problem.problem.start.len());
        match start.and_then(|start| start(&problem.problem)) {
            Some(stepper) => Some(StartedStepper::asked(self, stepper)),
            None => Dop853.begin(problem).map(|begun| begun.because("it has too many entries")),
        }
    }
}
