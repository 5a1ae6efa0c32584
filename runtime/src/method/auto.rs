//! The method that suits a phase.

use super::{Begun, Dop853, Method, Problem, Radau, Taylor, Tsit5};
use crate::model::{BarSystem, PhaseSeries, jacobian};

/// Rates of decay faster than this many natural times are stiff: what they take away is gone long before anything else
/// moves.
const STIFF: f64 = 1e3;
/// Tolerances looser than this are met by a pair of order 5 with less work.
const LOOSE: f64 = 1e-5;

const DAMPED: &str = "its damping is stiff";

/// Chooses for each phase, and says why in [`Segment::choice`](crate::Segment::choice): [`Radau`] where damping is
/// stiff at its start, −tr ∂f/∂y ≫ 1 in natural times; else [`Taylor`] where there is a closed form; else [`Dop853`], or
/// [`Tsit5`] at loose tolerances.
#[derive(Debug, Clone, Copy, Default)]
pub struct Auto;

impl Method for Auto {
    fn name(&self) -> &'static str {
        "auto"
    }

    fn takes_series(&self) -> bool {
        true
    }

    fn begin<'a, M: BarSystem, const N: usize>(&self, problem: Problem<'a, M, N>) -> Begun<'a, N> {
        if is_stiff(&problem) {
            Radau.begin(problem).because(DAMPED)
        } else if problem.progress.tolerance().relative() > LOOSE {
            Tsit5.begin(problem).because("it has no closed form, and the tolerance is loose")
        } else {
            Dop853.begin(problem).because("it has no closed form")
        }
    }

    fn begin_series<'a, M: BarSystem, const N: usize, Q: PhaseSeries<M, N>>(
        &self,
        problem: Problem<'a, M, N>,
    ) -> Begun<'a, N> {
        if is_stiff(&problem) {
            Radau.begin(problem).because(DAMPED)
        } else {
            let begun = Taylor.begin_series::<M, N, Q>(problem);
            begun.because("it has a closed form, and so Taylor series")
        }
    }
}

/// Whether something is damped, and so that the sum of all rates of growth is below −[`STIFF`] per natural time.
fn is_stiff<M: BarSystem, const N: usize>(problem: &Problem<M, N>) -> bool {
    if !problem.damped {
        return false;
    }
    let constants = M::from_parameters(problem.parameters).constants();
    let (phase, start) = (problem.phase, problem.progress.state());
    let slopes = jacobian::<M, N>(&constants, phase.set, phase.form, start);
    let growth: f64 = (0..N).map(|i| slopes[i][i]).sum();
    -growth * problem.time > STIFF
}
