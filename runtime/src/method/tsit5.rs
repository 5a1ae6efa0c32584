//! Tsitouras's pair as a method.

use super::{Begun, Method, Problem};
use crate::integrate;
use crate::model::BarSystem;

/// Tsitouras's explicit Runge–Kutta pair of order 5, for tolerances of 1e-5 and looser: [`integrate::Tsit5`].
#[derive(Debug, Clone, Copy, Default)]
pub struct Tsit5;

impl Method for Tsit5 {
    fn name(&self) -> &'static str {
        "tsit5"
    }

    fn begin<'a, M: BarSystem, const N: usize>(&self, problem: Problem<'a, M, N>) -> Begun<'a, N> {
        Begun::asked(self, integrate::Tsit5::new(problem.rates, problem.progress))
    }
}
