//! Gauss's method as a method.

use super::{Dop853, Method, Problem, StartedStepper};
use crate::system::erased;

/// Gauss collocation of order 12 with a constant step, for long smooth runs without drift of the
/// energy: [`crate::integrate::Gauss`]; DOP853 beyond 1024 entries.
#[derive(Debug, Clone, Copy, Default)]
pub struct Gauss;

impl Method for Gauss {
    fn name(&self) -> &'static str {
        "gauss"
    }

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        let start = erased::gauss(problem.problem.start.len());
        match start.and_then(|start| start(&problem.problem)) {
            Some(stepper) => Some(StartedStepper::asked(self, stepper)),
            None => Dop853.begin(problem).map(|begun| begun.because("it has too many entries")),
        }
    }
}
