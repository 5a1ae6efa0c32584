//! Tsitouras's pair as a method.

use super::{Method, Problem, StartedStepper};

/// Tsitouras's explicit Runge–Kutta pair of order 5, for tolerances of 1e-5 and looser:
/// [`crate::integrate::Tsit5`].
#[derive(Debug, Clone, Copy, Default)]
pub struct Tsit5;

impl Method for Tsit5 {
    fn name(&self) -> &'static str {
        "tsit5"
    }

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        Some(StartedStepper::asked(self, problem.start_tsit5()?))
    }
}
