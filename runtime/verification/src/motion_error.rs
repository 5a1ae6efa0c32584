//! Why there is no motion, or only part of one.

use liftoff::{OutputError, RunCause, RunError, Trajectory};
use std::error::Error;

/// Why there is no motion, or only part of one.
#[derive(thiserror::Error)]
pub enum MotionError {
    /// An invalid request: an unknown name, or a value out of range.
    #[error("{0}")]
    Input(String),
    /// A run that stopped short.
    #[error("{reason}")]
    Run {
        /// Why.
        reason: String,
        /// The motion up to there.
        trajectory: Box<Trajectory>,
    },
}

impl std::fmt::Debug for MotionError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self}")
    }
}

impl From<OutputError> for MotionError {
    fn from(error: OutputError) -> Self {
        input(error)
    }
}

/// An invalid request.
pub fn input(error: impl Error) -> MotionError {
    MotionError::Input(chain(&error))
}

/// A run that stopped short, with its motion; an invalid request, if that is why.
pub fn stopped(error: RunError) -> MotionError {
    match error.cause() {
        cause @ (RunCause::Tolerance(_) | RunCause::Limit(_) | RunCause::Start(_)) => input(cause),
        _ => MotionError::Run { reason: chain(&error), trajectory: Box::new(error.into_trajectory()) },
    }
}

/// A motion as far as it came, and why it came no further.
///
/// # Errors
/// An invalid request, of which there is none.
pub fn as_far(run: Result<Trajectory, MotionError>) -> Result<(Trajectory, Option<String>), MotionError> {
    match run {
        Ok(record) => Ok((record, None)),
        Err(MotionError::Run { reason, trajectory }) => Ok((*trajectory, Some(reason))),
        Err(mistake) => Err(mistake),
    }
}

/// An error with its sources in one line; a source that its error repeats is left out.
pub fn chain(error: &dyn Error) -> String {
    let mut line = error.to_string();
    let mut next = error.source();
    while let Some(source) = next {
        let text = source.to_string();
        if !line.contains(&text) {
            line = format!("{line}: {text}");
        }
        next = source.source();
    }
    line
}
