//! Why there is no motion, or only part of one.

use super::Record;
use crate::model::BarSystem;
use crate::{RunCause, RunError};
use std::error::Error;

/// Why there is no motion, or only part of one.
#[derive(thiserror::Error)]
pub enum Failure {
    /// Something asked for that the model does not have, or that makes no sense.
    #[error("{0}")]
    Input(String),
    /// A run that stopped short.
    #[error("{reason}")]
    Run {
        /// Why.
        reason: String,
        /// The motion up to there.
        record: Box<dyn Record>,
    },
}

impl std::fmt::Debug for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self}")
    }
}

/// A mistake of what was asked for.
pub fn input(error: impl Error) -> Failure {
    Failure::Input(chain(&error))
}

/// A run that stopped short, with its motion; a mistake of what was asked for, if that is why.
pub fn stopped<M: BarSystem>(error: RunError<M>) -> Failure {
    match error.cause() {
        cause @ (RunCause::Tolerance(_) | RunCause::Limit(_) | RunCause::Start(_)) => input(cause),
        _ => Failure::Run { reason: chain(&error), record: Box::new(error.into_trajectory()) },
    }
}

/// An error with its sources in one line; a source that its error repeats is left out.
pub(crate) fn chain(error: &dyn Error) -> String {
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
