//! What keeps a sweep from being made.

use crate::catalog::Failure;
use crate::error::{NameError, SupportError};
use crate::output::OutputError;
use crate::plot::DrawingError;
use std::path::PathBuf;

/// What keeps a sweep from being made. Members that fail do not: they are kept in its table.
#[derive(thiserror::Error, Debug)]
pub enum SweepError {
    /// Text that says nothing that can be swept.
    #[error("`{text}`: {reason}")]
    Words {
        /// What was said.
        text: String,
        /// What is wrong with it.
        reason: String,
    },
    /// An unknown name.
    #[error(transparent)]
    Name(#[from] NameError),
    /// An unknown support.
    #[error(transparent)]
    Support(#[from] SupportError),
    /// What was asked for does not fit together.
    #[error("{0}")]
    Asked(String),
    /// A file that cannot be read or written.
    #[error("cannot {doing} {}: {source}", path.display())]
    File {
        /// What was to be done with it.
        doing: &'static str,
        /// Which.
        path: PathBuf,
        /// Why not.
        source: std::io::Error,
    },
    /// A journal of another sweep, or no journal.
    #[error("{} {reason}", path.display())]
    Journal {
        /// Which.
        path: PathBuf,
        /// What it is instead.
        reason: String,
    },
    /// Threads that could not be started.
    #[error("cannot start {threads} threads: {reason}")]
    Threads {
        /// So many.
        threads: usize,
        /// Why not.
        reason: String,
    },
    /// A drawing that could not be made.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
}

impl SweepError {
    pub(super) fn words(text: &str, reason: impl ToString) -> Self {
        Self::Words { text: text.trim().to_owned(), reason: reason.to_string() }
    }

    pub(super) fn output(text: &str) -> impl Fn(OutputError) -> Self {
        move |error| Self::words(text, error)
    }

    /// Whether it is what was asked for that makes no sense.
    pub fn is_mistake(&self) -> bool {
        !matches!(self, Self::File { .. } | Self::Threads { .. } | Self::Drawing(_))
    }
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        Self::Input(error.to_string())
    }
}
