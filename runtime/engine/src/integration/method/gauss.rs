//! Gauss's method as a method.

use super::{Method, Problem, StartedStepper};
use crate::integrate::erased;

/// Gauss collocation of order 12 with a constant step, for long smooth runs without drift of the energy:
/// [`crate::integrate::Gauss`].
#[derive(Debug, Clone, Copy, Default)]
pub struct Gauss;

impl Method for Gauss {
    fn name(&self) -> &'static str {
        "gauss"
    }

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        Some(StartedStepper::asked(self, erased::gauss(&problem.problem)?))
    }
}
