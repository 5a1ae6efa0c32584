//! DOP853 as a method.

use super::{Method, Problem, StartedStepper};

/// Dormand and Prince's explicit Runge–Kutta method of order 8: [`crate::integrate::Dop853`].
#[derive(Debug, Clone, Copy, Default)]
pub struct Dop853;

impl Method for Dop853 {
    fn name(&self) -> &'static str {
        "dop853"
    }

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        Some(StartedStepper::asked(self, problem.start_dop853()?))
    }
}
