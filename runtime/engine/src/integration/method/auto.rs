//! The method that suits a phase.

use super::stiffness::{damping, watched};
use super::{Dop853, Method, Problem, StartedStepper, Taylor, Tsit5};
use crate::integrate::erased;
use crate::model::Form;

/// Damping is stiff where −tr ∂f/∂y exceeds this per natural time: what it damps has decayed long before anything else moves.
pub(super) const STIFF: f64 = 1e3;
/// Tolerances looser than this are met by a pair of order 5 with less work.
const LOOSE: f64 = 1e-5;
/// At tighter tolerances DOP853 takes so many steps that the series of the full equations take less time.
const TIGHT: f64 = 1e-11;

/// Chooses for each phase, and says why in [`Segment::choice`](crate::Segment::choice): [`Radau`](super::Radau) where damping is
/// stiff at its start, −tr ∂f/∂y ≫ 1 in natural times; else [`Taylor`] where there are series
/// that are worth their time; else [`Dop853`], or
/// [`Tsit5`] at loose tolerances. Where damping becomes stiff on the way, or is so no longer, it changes the method, and logs
/// that.
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
        let implicit = if is_stiff(problem) { erased::radau(&problem.problem) } else { None };
        explicit(problem).map(|begun| watched(begun, problem, implicit))
    }
}

/// What integrates where damping is not stiff.
fn explicit<'a>(problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
    let because = |why| move |begun: StartedStepper<'a>| begun.because(why);
    if !series_pay(problem) {
        Dop853.begin(problem).map(because("its Taylor series would take longer"))
    } else if let Some(stepper) = erased::taylor(&problem.problem) {
        Some(StartedStepper::asked(&Taylor, stepper).because("it has Taylor series"))
    } else if problem.problem.relative > LOOSE {
        Tsit5.begin(problem).map(because("it has no Taylor series, and the tolerance is loose"))
    } else {
        Dop853.begin(problem).map(because("it has no Taylor series"))
    }
}

/// Whether Taylor's method is the faster one, if there are series: those of the full equations, where there is nothing to watch, are
/// only at tight tolerances.
fn series_pay(Problem { problem, .. }: &Problem) -> bool {
    let is_closed_form = problem.phase.info().form == Form::Closed;
    let has_contacts = !problem.phase.system().layout().contacts.is_empty();
    is_closed_form || has_contacts || problem.relative < TIGHT
}

/// Whether there is damping and −tr ∂f/∂y exceeds [`STIFF`] per natural time.
fn is_stiff(Problem { problem, time, damped }: &Problem) -> bool {
    if !damped {
        return false;
    }
    let Some(jacobian) = problem.phase.jacobian() else { return false };
    damping(&jacobian, problem.start) * time > STIFF
}
