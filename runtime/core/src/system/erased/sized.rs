//! One capacity of a method: it integrates states of at most so many entries, filled up with
//! entries that stand still.

use super::expansion::Padded;
use super::problem::JacobianMatrix;
use super::{InitialValueProblem, PhaseStepper};
use crate::integrate::{Dop853, Gauss, Radau, StepState, Stepper, Taylor, Tsit5};

/// An integration of the first `entries` entries of `N`.
pub(super) struct Sized<T, const N: usize> {
    pub(super) stepper: T,
    pub(super) entries: usize,
}

impl<'a> InitialValueProblem<'a> {
    /// An integration of the problem; none where its tolerance is none.
    fn stepper<const N: usize, T: Stepper<f64, N> + 'a>(
        &self,
        begin: impl FnOnce(StepState<f64, N>) -> T,
    ) -> Option<Box<dyn PhaseStepper + 'a>> {
        Some(Box::new(Sized { stepper: begin(self.step_state()?), entries: self.len() }))
    }
}

type Started<'a> = Option<Box<dyn PhaseStepper + 'a>>;

pub(super) fn dop853<'a, const N: usize>(problem: &InitialValueProblem<'a>) -> Started<'a> {
    problem.stepper::<N, _>(|step_state| Dop853::new(problem.rates(), step_state))
}

pub(super) fn tsit5<'a, const N: usize>(problem: &InitialValueProblem<'a>) -> Started<'a> {
    problem.stepper::<N, _>(|step_state| Tsit5::new(problem.rates(), step_state))
}

pub(super) fn taylor<'a, const N: usize>(problem: &InitialValueProblem<'a>) -> Started<'a> {
    let expansion = Padded::<N>::from_problem(problem)?;
    problem.stepper::<N, _>(|step_state| Taylor::new(expansion, step_state))
}

pub(super) fn radau<'a, const N: usize>(problem: &InitialValueProblem<'a>) -> Started<'a> {
    let jacobian = JacobianMatrix::<N>::from_problem(problem);
    problem.stepper::<N, _>(|step_state| {
        Radau::new(problem.rates(), move |y: &[f64; N]| jacobian.evaluate(y), step_state)
    })
}

pub(super) fn gauss<'a, const N: usize>(problem: &InitialValueProblem<'a>) -> Started<'a> {
    problem.stepper::<N, _>(|step_state| {
        let pairs = problem.pairs::<N>(&step_state);
        Gauss::new(problem.rates(), step_state).with_pairs(pairs)
    })
}
