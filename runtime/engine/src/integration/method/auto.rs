//! The method that suits a phase.

use super::{Dop853, Method, Problem, Radau, StartedStepper, Taylor, Tsit5};
use crate::integrate::erased;

/// Damping is stiff where −tr ∂f/∂y exceeds this per natural time: what it damps has decayed long before anything else moves.
const STIFF: f64 = 1e3;
/// Tolerances looser than this are met by a pair of order 5 with less work.
const LOOSE: f64 = 1e-5;

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

    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
        let because = |why| move |begun: StartedStepper<'a>| begun.because(why);
        if is_stiff(problem) {
            return match erased::radau(&problem.problem) {
                Some(stepper) => Some(StartedStepper::asked(&Radau, stepper).because("its damping is stiff")),
                None => {
                    Dop853.begin(problem).map(because("its damping is stiff, but it has too many entries"))
                }
            };
        }
        if let Some(stepper) = erased::taylor(&problem.problem) {
            return Some(
                StartedStepper::asked(&Taylor, stepper).because("it has a closed form, and so Taylor series"),
            );
        }
        if problem.problem.relative > LOOSE {
            Tsit5.begin(problem).map(because("it has no closed form, and the tolerance is loose"))
        } else {
            Dop853.begin(problem).map(because("it has no closed form"))
        }
    }
}

/// Whether there is damping and −tr ∂f/∂y exceeds [`STIFF`] per natural time.
fn is_stiff(Problem { problem, time, damped }: &Problem) -> bool {
    if !damped {
        return false;
    }
    let Some(jacobian) = problem.phase.jacobian() else { return false };
    let n = problem.start.len();
    let mut entries = vec![0.0; n * n];
    jacobian(problem.start, &mut entries);
    let growth: f64 = entries.iter().step_by(n + 1).sum();
    -growth * time > STIFF
}
