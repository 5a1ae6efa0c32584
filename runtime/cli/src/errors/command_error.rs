//! Why a command failed.

use crate::errors::interrupted;
use liftoff::OutputError;
use liftoff_analysis::Ending;
use liftoff_studio::analyses::{Failure, VariableError, describe_stop};
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
    /// A failure of what the values of an option ask for.
    pub fn with_option(option: &str, failure: Failure) -> Self {
        match failure {
            Failure::Name(error) => Self::Usage(format!("{option} {error}")),
            Failure::Variable(error) => Self::Usage(match &error {
                VariableError::Twice(_) => format!("{option}: {error}"),
                VariableError::Unknown { name, .. } => {
                    format!("{option} {error}; --start '{name}=…' gives it")
                }
                VariableError::Outside(_) => format!("{option} {error}"),
            }),
            failure => failure.into(),
        }
    }

    /// Fails where a search whose best values have been printed was stopped.
    pub fn unless_converged(ending: &Ending) -> Result<(), Self> {
        describe_stop(ending).map_or(Ok(()), |text| Err(Self::Failed(text)))
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
            Failure::Variable(error) => Self::Usage(error.to_string()),
            Failure::Input(text) => Self::Usage(text),
            Failure::NotFound(text) => Self::Failed(text),
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
