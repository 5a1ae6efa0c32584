//! Tsitouras's pair as a method.

use super::{Method, Problem};
use crate::integrate::{self, Stepper};
use crate::model::BarSystem;

/// Tsitouras's explicit Runge–Kutta pair of order 5, for tolerances of 1e-5 and looser: [`integrate::Tsit5`].
#[derive(Debug, Clone, Copy, Default)]
pub struct Tsit5;

impl Method for Tsit5 {
    fn name(&self) -> &'static str {
        "tsit5"
    }

    fn begin<'a, M: BarSystem, const N: usize>(
        &self,
        problem: Problem<'a, M, N>,
    ) -> Box<dyn Stepper<f64, N> + 'a> {
        Box::new(integrate::Tsit5::new(problem.rates, problem.progress))
    }
}
