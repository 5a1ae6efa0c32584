//! The method that suits a phase.

use super::{Choice, Dop853, Method, Problem, Radau, Taylor, Tsit5};
use crate::integrate::Stepper;
use crate::model::{BarSystem, PhaseSeries, jacobian};

/// Rates of decay faster than this many natural times are stiff: what they take away is gone long before anything else
/// moves.
const STIFF: f64 = 1e3;
/// Tolerances looser than this are met by a pair of order 5 with less work.
const LOOSE: f64 = 1e-5;

/// Chooses for each phase, and says why in [`Segment::choice`](crate::Segment::choice): [`Radau`] where damping is
/// stiff at its start, −tr ∂f/∂y ≫ 1 in natural times; else [`Taylor`] where there is a closed form; else [`Dop853`], or
/// [`Tsit5`] at loose tolerances.
#[derive(Debug, Clone, Copy, Default)]
pub struct Auto;

#[derive(Clone, Copy)]
enum Pick {
    Radau,
    Taylor,
    Dop853,
    Tsit5,
}

impl Pick {
    fn of<M: BarSystem, const N: usize>(problem: &Problem<M, N>, has_series: bool) -> Self {
        if is_stiff(problem) {
            Self::Radau
        } else if has_series {
            Self::Taylor
        } else if problem.progress.tolerance().relative() > LOOSE {
            Self::Tsit5
        } else {
            Self::Dop853
        }
    }
}

impl Method for Auto {
    fn name(&self) -> &'static str {
        "auto"
    }

    fn takes_series(&self) -> bool {
        true
    }

    fn choice<M: BarSystem, const N: usize>(&self, problem: &Problem<M, N>, has_series: bool) -> Choice {
        let (method, why) = match Pick::of(problem, has_series) {
            Pick::Radau => (Radau.name(), "its damping is stiff"),
            Pick::Taylor => (Taylor.name(), "it has a closed form, and so Taylor series"),
            Pick::Tsit5 => (Tsit5.name(), "it has no closed form, and the tolerance is loose"),
            Pick::Dop853 => (Dop853.name(), "it has no closed form"),
        };
        Choice { method, why }
    }

    fn begin<'a, M: BarSystem, const N: usize>(
        &self,
        problem: Problem<'a, M, N>,
    ) -> Box<dyn Stepper<f64, N> + 'a> {
        match Pick::of(&problem, false) {
            Pick::Radau => Radau.begin(problem),
            Pick::Tsit5 => Tsit5.begin(problem),
            Pick::Taylor | Pick::Dop853 => Dop853.begin(problem),
        }
    }

    fn begin_series<'a, M: BarSystem, const N: usize, Q: PhaseSeries<M, N>>(
        &self,
        problem: Problem<'a, M, N>,
    ) -> Box<dyn Stepper<f64, N> + 'a> {
        match Pick::of(&problem, true) {
            Pick::Radau => Radau.begin(problem),
            _ => Taylor.begin_series::<M, N, Q>(problem),
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
