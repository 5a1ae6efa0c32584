//! Why a command failed.

use crate::errors::interrupted;
use liftoff::OutputError;
use liftoff_analysis::{Ending, FitError, OptimumError, OrbitError};
use liftoff_studio::analyses::Failure;
use liftoff_studio::registry::MotionError;
use liftoff_studio::work_precision::FileError;

/// Why a command failed.
#[derive(thiserror::Error, Debug)]
pub enum CommandError {
    /// An invalid request: exit code 2.
    #[error("{0}")]
    Usage(String),
    /// Something that went wrong on the way.
    #[error("{0}")]
    Failed(String),
    /// Mistakes in a source file, as they are printed.
    #[error("{0}")]
    Mistakes(String),
    /// Ctrl-C; what was done by then has been printed.
    #[error("{0}")]
    Interrupted(String),
}

impl CommandError {
    /// The exit code of a program that ends with this.
    pub fn code(&self) -> i32 {
        match self {
            Self::Usage(_) => 2,
            Self::Failed(_) | Self::Mistakes(_) => 1,
            Self::Interrupted(_) => interrupted::CODE,
        }
    }
}

impl CommandError {
    /// Fails where a search whose best values have been printed was stopped.
    pub fn unless_converged(ending: &Ending) -> Result<(), Self> {
        match ending {
            Ending::Converged => Ok(()),
            Ending::Stopped(why) => Err(Self::Failed(format!(
                "the search has not converged; these are the best values so far: {why}"
            ))),
        }
    }
}

impl From<MotionError> for CommandError {
    fn from(failure: MotionError) -> Self {
        match failure {
            MotionError::Input(text) => Self::Usage(text),
            MotionError::Run { reason, .. } => Self::Failed(reason),
        }
    }
}

impl From<OutputError> for CommandError {
    fn from(error: OutputError) -> Self {
        MotionError::from(error).into()
    }
}

impl From<Failure> for CommandError {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Name(error) => Self::Usage(error.to_string()),
            Failure::Input(text) => Self::Usage(text),
            Failure::NotFound(text) => Self::Failed(text),
        }
    }
}

impl From<OrbitError> for CommandError {
    fn from(error: OrbitError) -> Self {
        match error {
            OrbitError::Event(_) | OrbitError::Section { .. } => Self::Usage(error.to_string()),
            _ => Self::Failed(error.to_string()),
        }
    }
}

impl From<FitError> for CommandError {
    fn from(error: FitError) -> Self {
        match error {
            FitError::NoVariable | FitError::TooFew { .. } => Self::Usage(error.to_string()),
            FitError::Start(_) | FitError::Undetermined(_) => Self::Failed(error.to_string()),
        }
    }
}

impl From<OptimumError> for CommandError {
    fn from(error: OptimumError) -> Self {
        match error {
            OptimumError::Outside { .. } => Self::Usage(format!("--vary {error}")),
            OptimumError::NoVariable => Self::Usage(error.to_string()),
            OptimumError::Start(_) => Self::Failed(error.to_string()),
        }
    }
}

impl From<std::io::Error> for CommandError {
    fn from(error: std::io::Error) -> Self {
        Self::Failed(format!("cannot print: {error}"))
    }
}

impl From<FileError> for CommandError {
    fn from(error: FileError) -> Self {
        match error {
            FileError::File { .. } => Self::Failed(error.to_string()),
            FileError::Row { .. } | FileError::Empty(_) => Self::Usage(error.to_string()),
        }
    }
}
