//! Integrations of a phase with its dimension forgotten. One copy of each method serves all models: of each capacity that
//! `sized` lists, the state filled up with entries that stand still.

mod by_orders;
mod dense;
mod expansion;
mod problem;
mod sized;

pub use by_orders::{ByOrders, SeriesOrders};
pub use dense::DenseOutput;
pub use expansion::SeriesExpansion;
pub use problem::InitialValueProblem;

use super::{Counts, Dop853, Gauss, Guards, Radau, StepError, StepState, Stepper, Taylor, Tsit5};
use expansion::Padded;
use problem::JacobianMatrix;
use sized::{Sized, sized};

/// An integration of a phase in step_state, forwards in time; see [`Stepper`].
pub trait PhaseStepper {
    /// Time of the last accepted state.
    fn time(&self) -> f64;
    /// The last accepted reduced state.
    fn state(&self) -> &[f64];
    /// The step that will be tried next, once one has been made or proposed.
    fn next_step(&self) -> Option<f64>;
    /// The work done so far.
    fn counts(&self) -> Counts;
    /// From now on steps may be as long as `h` too.
    fn allow_step(&mut self, h: f64);
    /// From now on some step ends exactly at time `t`, and none goes past it.
    fn set_end(&mut self, t: f64);
    /// Goes on from another time and state, `h` the first step tried there.
    fn jump(&mut self, t: f64, state: &[f64], h: f64);
    /// Makes one step.
    fn step(&mut self) -> Result<(), StepError>;
    /// The last step as a polynomial.
    fn dense(&mut self, dense: &mut DenseOutput);
    /// Replaces the end of the last step, by a projection say.
    fn replace_end(&mut self, y1: &[f64]) -> Result<(), StepError>;
    /// The series of what tells when contacts open or close over the last step, if the method has them.
    fn guards(&mut self) -> Option<Guards<'_>>;
}

/// An integration by DOP853.
pub fn dop853<'a>(problem: &InitialValueProblem<'a>) -> Option<Box<dyn PhaseStepper + 'a>> {
    sized!(explicit problem.len(), N => problem.stepper::<N, _>(|step_state| Dop853::new(problem.rates(), step_state)))
}

/// An integration by Tsitouras's pair.
pub fn tsit5<'a>(problem: &InitialValueProblem<'a>) -> Option<Box<dyn PhaseStepper + 'a>> {
    sized!(explicit problem.len(), N => problem.stepper::<N, _>(|step_state| Tsit5::new(problem.rates(), step_state)))
}

/// An integration by Gauss's method.
pub fn gauss<'a>(problem: &InitialValueProblem<'a>) -> Option<Box<dyn PhaseStepper + 'a>> {
    sized!(gauss problem.len(), N => problem.stepper::<N, _>(|step_state| {
        let pairs = problem.pairs::<N>(&step_state);
        Gauss::new(problem.rates(), step_state).with_pairs(pairs)
    }))
}

/// An integration by Radau's method; none where the phase is too large for a Jacobian in place.
pub fn radau<'a>(problem: &InitialValueProblem<'a>) -> Option<Box<dyn PhaseStepper + 'a>> {
    sized!(radau problem.len(), N => {
        let jacobian = JacobianMatrix::<N>::of(problem);
        problem.stepper::<N, _>(|step_state| Radau::new(problem.rates(), move |y: &[f64; N]| jacobian.at(y), step_state))
    })
}

/// An integration by Taylor's method; none where the phase has no series.
pub fn taylor<'a>(problem: &InitialValueProblem<'a>) -> Option<Box<dyn PhaseStepper + 'a>> {
    sized!(explicit problem.len(), N => {
        let expansion = Padded::<N>::of(problem)?;
        problem.stepper::<N, _>(|step_state| Taylor::new(expansion, step_state))
    })
}

impl<T: Stepper<f64, N>, const N: usize> PhaseStepper for Sized<T, N> {
    fn time(&self) -> f64 {
        self.stepper.step_state().time()
    }

    fn state(&self) -> &[f64] {
        &self.stepper.step_state().state()[..self.entries]
    }

    fn next_step(&self) -> Option<f64> {
        self.stepper.step_state().next_step()
    }

    fn counts(&self) -> Counts {
        self.stepper.step_state().counts()
    }

    fn allow_step(&mut self, h: f64) {
        self.stepper.step_state_mut().allow_step(h);
    }

    fn set_end(&mut self, t: f64) {
        self.stepper.step_state_mut().set_end(t);
    }

    fn jump(&mut self, t: f64, state: &[f64], h: f64) {
        let state = filled(state, 0.0);
        self.stepper.step_state_mut().jump(t, state, h);
    }

    fn step(&mut self) -> Result<(), StepError> {
        self.stepper.step()
    }

    fn dense(&mut self, dense: &mut DenseOutput) {
        dense.set(self.stepper.dense(), self.entries);
    }

    fn replace_end(&mut self, y1: &[f64]) -> Result<(), StepError> {
        self.stepper.replace_end(filled(y1, 0.0))
    }

    fn guards(&mut self) -> Option<Guards<'_>> {
        self.stepper.guards()
    }
}

/// A slice as an array, filled up.
fn filled<const N: usize>(values: &[f64], filling: f64) -> [f64; N] {
    core::array::from_fn(|i| values.get(i).copied().unwrap_or(filling))
}

impl InitialValueProblem<'_> {
    fn step_state<const N: usize>(&self) -> Option<StepState<f64, N>> {
        let tolerance = super::Tolerance::of_first(self.relative, self.absolute).ok()?.times(self.tightness);
        let step_state = StepState::new(tolerance, self.t, filled(self.start, 0.0)).with_end(self.end);
        Some(match self.longest {
            Some(h) => step_state.with_longest_step(h),
            None => step_state,
        })
    }
}
