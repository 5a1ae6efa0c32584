//! Integration of autonomous systems y′ = f(y), time carried alongside.
//!
//! A method is a [`Stepper`]: it makes steps, and shows the last one as a polynomial, [`Dense`].
//! [`Tolerance`], [`StepState`] (where an integration is, and how long its next step may be), the
//! first step, the step controller, [`Counts`] and [`StepError`] know no method.

mod combination;
mod controller;
mod dense;
mod dop853;
mod explicit;
mod gauss;
mod growth;
mod initial_step;
#[cfg(feature = "std")]
mod radau;
mod rhs_cache;
mod step_state;
mod store;
mod taylor;
#[cfg(test)]
mod tests;
mod tolerance;
mod tsit5;

pub use dense::Dense;
pub use dop853::Dop853;
pub use explicit::Explicit;
pub use gauss::Gauss;
#[cfg(feature = "std")]
pub use radau::Radau;
pub use step_state::StepState;
pub(crate) use taylor::ExpansionBy;
#[cfg(feature = "std")]
pub use taylor::{Ended, LaneStepper};
pub use taylor::{Expansion, Guards, PhaseExpansion, Taylor};
pub use tolerance::{Tolerance, ToleranceError};
pub use tsit5::Tsit5;

use crate::scalar::Scalar;

/// f of y′ = f(y).
pub type Rates<'a, S, const N: usize> = &'a dyn Fn(&[S; N]) -> [S; N];

/// ∂f/∂y, row `i` that of fᵢ.
pub type JacobianFn<'a, S, const N: usize> = &'a dyn Fn(&[S; N]) -> [[S; N]; N];

/// An integration in progress, forward in time.
pub trait Stepper<S: Scalar, const N: usize> {
    /// Where the integration is.
    fn step_state(&self) -> &StepState<S, N>;
    /// The same, to set an end or to go on from elsewhere.
    fn step_state_mut(&mut self) -> &mut StepState<S, N>;
    /// Makes one step.
    fn step(&mut self) -> Result<(), StepError>;
    /// The last step as a polynomial, computed when asked for.
    fn dense(&mut self) -> &Dense<S, N>;
    /// Replaces the end of the last step, by a projection say; the step size is kept. The dense
    /// output that is asked for afterwards ends there.
    fn replace_end(&mut self, y1: [S; N]) -> Result<(), StepError>;
    /// The series of what tells when contacts open or close over the last step, if the method has
    /// them.
    fn guards(&mut self) -> Option<Guards<'_>> {
        None
    }
}

/// The work done so far.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Counts {
    /// Evaluations of f, dense output and first step included; of a Taylor method, coefficients of
    /// f.
    pub evaluations: u64,
    /// Evaluations of the Jacobian.
    pub jacobians: u64,
    /// Accepted steps.
    pub accepted: u64,
    /// Rejected steps.
    pub rejected: u64,
}

impl core::ops::Add for Counts {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            evaluations: self.evaluations + other.evaluations,
            jacobians: self.jacobians + other.jacobians,
            accepted: self.accepted + other.accepted,
            rejected: self.rejected + other.rejected,
        }
    }
}

/// Why a step was not made; the integrator stays at its last accepted state.
#[derive(Clone, Copy, PartialEq, Debug, thiserror::Error)]
pub enum StepError {
    /// The tolerance asks for a step that time cannot resolve.
    #[error("step size {h:e} is at its floor at t = {t}")]
    Floor {
        /// Time of the last accepted state.
        t: f64,
        /// The step that was refused.
        h: f64,
    },
    /// The fixed-point iteration of an implicit method converges with no step that time can
    /// resolve.
    #[error(
        "the iteration of Gauss's method does not converge at t = {t}, not with steps of {h:e} either: the methods auto, radau and \
         dop853 have none such"
    )]
    Iteration {
        /// Time of the last accepted state.
        t: f64,
        /// The step that was refused.
        h: f64,
    },
    /// The constant step of a symplectic method would have to be far shorter for the rest of the
    /// run.
    #[error(
        "the step of Gauss's method, the same throughout, is {longest:e} and would have to be {h:e} from t = {t} on: the methods auto, \
         radau and dop853 make theirs longer again"
    )]
    Constant {
        /// Time of the last accepted state.
        t: f64,
        /// The step that would do.
        h: f64,
        /// The longest step made.
        longest: f64,
    },
    /// The state or its derivative is infinite or not a number, however small the step.
    #[error("state or derivative not finite at t = {t}")]
    NotFinite {
        /// Time of the last accepted state.
        t: f64,
    },
    /// A reaction, a gap or a condition turns too often to be followed, however small the step.
    #[error("a guard turns too often to be followed at t = {t}")]
    Unresolved {
        /// Where it was not followed.
        t: f64,
    },
    /// The end has been reached.
    #[error("no time left to integrate over at t = {t}")]
    AtEnd {
        /// Time of the last accepted state.
        t: f64,
    },
}

fn is_finite<S: Scalar, const N: usize>(x: &[S; N]) -> bool {
    x.iter().all(|x| x.is_finite())
}
