//! Integrations of a phase with its dimension forgotten. One copy of each method serves all models:
//! of each capacity that `methods` lists, the state filled up with entries that stand still.

mod by_orders;
mod dense;
mod expansion;
mod methods;
mod problem;
mod sized;

pub use by_orders::{ByOrders, SeriesOrders};
pub use dense::DenseOutput;
pub use expansion::SeriesExpansion;
pub use methods::{ExplicitMethods, Methods, StartStepper, gauss, radau};
pub use problem::InitialValueProblem;

use crate::integrate::{Counts, Guards, StepError, StepState, Stepper, Tolerance};
use sized::Sized;

/// An integration of a phase in progress, forward in time; see [`Stepper`].
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
    /// The series of what tells when contacts open or close over the last step, if the method has
    /// them.
    fn guards(&mut self) -> Option<Guards<'_>>;
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
        let tolerance = Tolerance::of_first(self.relative, self.absolute).ok()?.times(self.tightness);
        let step_state = StepState::new(tolerance, self.t, filled(self.start, 0.0)).with_end(self.end);
        Some(match self.longest {
            Some(h) => step_state.with_longest_step(h),
            None => step_state,
        })
    }
}
