//! Taylor's method as a method.

use super::{Begun, Dop853, Method, Problem};
use crate::integrate::{self, PhaseExpansion};
use crate::model::{BarSystem, PhaseSeries};

/// Taylor's method of variable order, [`integrate::Taylor`], for the phases in closed form; DOP853 for the others.
#[derive(Debug, Clone, Copy, Default)]
pub struct Taylor;

impl Method for Taylor {
    fn name(&self) -> &'static str {
        "taylor"
    }

    fn takes_series(&self) -> bool {
        true
    }

    fn begin<'a, M: BarSystem, const N: usize>(&self, problem: Problem<'a, M, N>) -> Begun<'a, N> {
        Dop853.begin(problem).because("the phase has no closed form, and so no Taylor series")
    }

    fn begin_series<'a, M: BarSystem, const N: usize, Q: PhaseSeries<M, N>>(
        &self,
        problem: Problem<'a, M, N>,
    ) -> Begun<'a, N> {
        let expansion = PhaseExpansion::<M, Q, N>::new(problem.constants);
        Begun::asked(self, integrate::Taylor::new(expansion, problem.progress))
    }
}
