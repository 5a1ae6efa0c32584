//! Why an analysis gives nothing.

use liftoff::NameError;
use liftoff_replay::ReplayError;
use thiserror::Error;

/// Why an analysis gives nothing.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum AnalysisError {
    /// There is no such support.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A contact that is to be closed is open in the figure.
    #[error("{contact} is open by {gap:.3e}: give a start in which it is closed")]
    Open {
        /// The contact.
        contact: String,
        /// Its gap, m.
        gap: f64,
    },
    /// The equations depend on the time: nothing stays at rest.
    #[error("the equations depend on the time: there is no equilibrium")]
    Timed,
    /// Hinges with friction rest anywhere within it.
    #[error(
        "a hinge with friction rests wherever its torque is within its limit: equilibria are not isolated"
    )]
    HingeFriction,
    /// A mass matrix is singular.
    #[error("the mass matrix is singular at this position: its accelerations are not determined")]
    Massless,
    /// A position, or the contacts that are closed at it, are not their own mirror images.
    #[error(
        "these equations are not those of their mirror image: give a symmetric position, and close contacts together with their \
         images"
    )]
    Asymmetric,
    /// A value of a parameter makes no model, or has no start.
    #[error("at the value {value}: {why}")]
    Value {
        /// The value.
        value: f64,
        /// Why not.
        why: String,
    },
    /// No contact set has an equilibrium near the figure.
    #[error(
        "no equilibrium found from this start in any of {tried} contact sets; give a start nearer to one, or check the loads"
    )]
    NotFound {
        /// How many sets have been tried.
        tried: usize,
    },
}

/// Why a run has no derivatives.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SensitivityError {
    /// There is nothing to differentiate with respect to.
    #[error("no parameter and no entry of the start is given to differentiate with respect to")]
    NoVariable,
    /// The start cannot be varied.
    #[error("the start cannot be varied with {variable}: {why}")]
    Start {
        /// What is varied.
        variable: String,
        /// Why not.
        why: String,
    },
    /// There are no equations on dual numbers.
    #[error("no equations with derivatives: {0}")]
    Model(String),
    /// The run cannot be computed on dual numbers, or has events without derivatives.
    #[error(transparent)]
    Replay(#[from] ReplayError),
}
