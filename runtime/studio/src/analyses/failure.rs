//! Why an analysis of a model by name gives nothing.

use crate::registry::MotionError;
use liftoff::NameError;
use liftoff_analysis::AnalysisError;

/// Why an analysis of a model by name gives nothing.
#[derive(thiserror::Error, Debug)]
pub enum Failure {
    /// A name that the model does not have.
    #[error(transparent)]
    Name(#[from] NameError),
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
