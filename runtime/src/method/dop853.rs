//! DOP853 as a method.

use super::{Begun, Method, Problem};
use crate::integrate;
use crate::model::BarSystem;

/// Dormand and Prince's explicit Runge–Kutta method of order 8: [`integrate::Dop853`].
#[derive(Debug, Clone, Copy, Default)]
pub struct Dop853;

impl Method for Dop853 {
    fn name(&self) -> &'static str {
        "dop853"
    }

    fn begin<'a, M: BarSystem, const N: usize>(&self, problem: Problem<'a, M, N>) -> Begun<'a, N> {
        Begun::asked(self, integrate::Dop853::new(problem.rates, problem.progress))
    }
}
