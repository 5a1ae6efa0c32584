//! The method that suits a phase.

use super::stiffness::{STIFF, damping, watched};
use super::{Dop853, Method, Problem, StartedStepper, Taylor, Tsit5};
use crate::model::Form;
use crate::numerics::zero::roundoff;
use crate::system::InitialValueProblem;

/// Tolerances looser than this are met by a pair of order 5 with less work.
const LOOSE: f64 = 1e-5;
/// At tighter tolerances DOP853 takes so many steps that the series of the full equations take less
/// time.
const TIGHT: f64 = 1e-11;

/// At this part of a tolerance errors of DOP853 are those of Taylor's method at the whole.
const AS_EXACT: f64 = 1e-2;
/// Of a closed form that has more products than this at 1e-6, times (1e-6/ε)^[`GROWTH`] at ε, the
/// series take longer than DOP853 as exact as they: an order takes 1.3 ns for each product, a
/// right-hand side some 35 ns and 0.4 ns for each; from 1e-6 to 1e-10 the number of right-hand
/// sides beside that of orders grows from 1.3 to 2.2. Chains of 4, 6, 8, 12, 16 bars, with 65, 168,
/// 236, 372, 508 products, take 0.8, 0.6, 0.4, 0.3, 0.23 of the time at 1e-6; of 6 and more bars
/// 0.85, 0.6, 0.45, 0.38 at 1e-10.
const PRODUCTS: f64 = 60.0;
const GROWTH: f64 = 0.12;

/// Chooses for each phase, and says why in [`Segment::choice`](crate::Segment::choice):
/// [`Radau`](super::Radau) where damping is stiff at its start, −tr ∂f/∂y ≫ 1 in natural times;
/// else [`Taylor`] where there are series that are worth their time; for long ones of closed forms
/// [`Dop853`] at a hundredth of the tolerance, as exact as they; else [`Dop853`], or [`Tsit5`] at
/// loose tolerances. Where damping, or a spring whose oscillation implicit steps pass over, proves
/// stiff on the way, or is so no longer, it changes the method, and logs that.
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
        let implicit = if is_stiff(problem) { problem.start_implicit() } else { None };
        explicit(problem).map(|begun| watched(begun, problem, implicit))
    }
}

/// What integrates where damping is not stiff.
fn explicit<'a>(problem: &Problem<'a>) -> Option<StartedStepper<'a>> {
    let because = |why| move |begun: StartedStepper<'a>| begun.because(why);
    if is_long(problem) {
        let exact = InitialValueProblem { tightness: AS_EXACT, ..problem.problem };
        let begun = Dop853.begin(&Problem { problem: exact, ..*problem });
        begun.map(because("its Taylor series would take longer"))
    } else if !series_pay(problem) {
        Dop853.begin(problem).map(because("its Taylor series would take longer"))
    } else if let Some(stepper) = problem.start_taylor() {
        Some(StartedStepper::asked(&Taylor, stepper).because("it has Taylor series"))
    } else if problem.problem.relative > LOOSE {
        Tsit5.begin(problem).map(because("it has no Taylor series, and the tolerance is loose"))
    } else {
        Dop853.begin(problem).map(because("it has no Taylor series"))
    }
}

/// Whether Taylor's method is the faster one, if there are series: those of the full equations,
/// where there is nothing to watch, are only at tight tolerances.
fn series_pay(Problem { problem, .. }: &Problem) -> bool {
    let is_closed_form = problem.phase.info().form == Form::Reduced;
    let has_contacts = !problem.phase.system().layout().contacts.is_empty();
    is_closed_form || has_contacts || problem.relative < TIGHT
}

/// Whether nothing is watched by the series of a closed form, and they take longer than DOP853 as
/// exact as they.
fn is_long(Problem { problem, .. }: &Problem) -> bool {
    let has_contacts = !problem.phase.system().layout().contacts.is_empty();
    let bound = PRODUCTS * (1e-6 / problem.relative).powf(GROWTH);
    !has_contacts && AS_EXACT * problem.relative >= roundoff(32.0) && problem.phase.products() as f64 > bound
}

/// Whether there is damping and −tr ∂f/∂y exceeds [`STIFF`] per natural time.
fn is_stiff(Problem { problem, time, damped }: &Problem) -> bool {
    if !damped {
        return false;
    }
    let Some(jacobian) = problem.phase.jacobian() else { return false };
    damping(&jacobian, problem.start) * time > STIFF
}
