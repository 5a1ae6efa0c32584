//! Integration of autonomous systems y′ = f(y), time carried alongside.
//!
//! A method brings its stages, a step type and a dense output of its own; [`Tolerance`], the first
//! step, the step controller, [`Counts`] and [`StepError`] know no method.

mod controller;
mod dop853;
mod initial_step;
mod tolerance;

pub use dop853::{Dop853, Interpolant, Step};
pub use tolerance::{Tolerance, ToleranceError};

/// The work done so far.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Counts {
    /// Evaluations of f, dense output and first step included.
    pub evaluations: u64,
    /// Accepted steps.
    pub accepted: u64,
    /// Rejected steps.
    pub rejected: u64,
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
    /// The state or its derivative is infinite or not a number, however small the step.
    #[error("state or derivative not finite at t = {t}")]
    NotFinite {
        /// Time of the last accepted state.
        t: f64,
    },
    /// The end has been reached.
    #[error("no time left to integrate over at t = {t}")]
    AtEnd {
        /// Time of the last accepted state.
        t: f64,
    },
}
