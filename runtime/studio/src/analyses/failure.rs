//! Why an analysis of a model by name gives nothing.

use super::VariableError;
use crate::registry::MotionError;
use liftoff::NameError;
use liftoff_analysis::{AnalysisError, Ending, FitError, OptimumError, OrbitError};

/// Why an analysis of a model by name gives nothing.
#[derive(thiserror::Error, Debug)]
pub enum Failure {
    /// A name that the model does not have.
    #[error(transparent)]
    Name(#[from] NameError),
    /// Something that cannot be varied.
    #[error(transparent)]
    Variable(#[from] VariableError),
    /// An invalid request.
    #[error("{0}")]
    Input(String),
    /// Nothing was found, or a run stopped short.
    #[error("{0}")]
    NotFound(String),
}

impl From<MotionError> for Failure {
    fn from(error: MotionError) -> Self {
        match error {
            MotionError::Input(text) => Self::Input(text),
            MotionError::Run { reason, .. } => Self::NotFound(reason),
        }
    }
}

impl From<AnalysisError> for Failure {
    fn from(error: AnalysisError) -> Self {
        match error {
            AnalysisError::Name(error) => Self::Name(error),
            AnalysisError::Open { .. } => Self::Input(error.to_string()),
            _ => Self::NotFound(error.to_string()),
        }
    }
}

impl From<OrbitError> for Failure {
    fn from(error: OrbitError) -> Self {
        match error {
            OrbitError::Event(_) | OrbitError::Section { .. } => Self::Input(error.to_string()),
            _ => Self::NotFound(error.to_string()),
        }
    }
}

impl From<OptimumError> for Failure {
    fn from(error: OptimumError) -> Self {
        match error {
            OptimumError::Outside { .. } => VariableError::Outside(error).into(),
            OptimumError::NoVariable => Self::Input(error.to_string()),
            OptimumError::Start(_) => Self::NotFound(error.to_string()),
        }
    }
}

impl From<FitError> for Failure {
    fn from(error: FitError) -> Self {
        match error {
            FitError::NoVariable | FitError::TooFew { .. } => Self::Input(error.to_string()),
            FitError::Start(_) | FitError::Undetermined(_) => Self::NotFound(error.to_string()),
        }
    }
}

/// What to say of a search that has not converged.
pub fn describe_stop(ending: &Ending) -> Option<String> {
    match ending {
        Ending::Converged => None,
        Ending::Stopped(why) => {
            Some(format!("the search has not converged; these are the best values so far: {why}"))
        }
    }
}
