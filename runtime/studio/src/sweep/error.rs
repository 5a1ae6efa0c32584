//! What keeps a sweep from being made.

use crate::registry::MotionError;
use liftoff::OutputError;
use liftoff::{NameError, SupportError};
use std::path::PathBuf;

/// What keeps a sweep from being made. Members that fail do not: they are kept in its table.
#[derive(thiserror::Error, Debug)]
pub enum SweepError {
    /// Text that cannot be read.
    #[error("`{text}`: {reason}")]
    Syntax {
        /// The text as it was given.
        text: String,
        /// What is wrong with it, and what was expected.
        reason: String,
    },
    /// An unknown name.
    #[error(transparent)]
    Name(#[from] NameError),
    /// An unknown support.
    #[error(transparent)]
    Support(#[from] SupportError),
    /// Options that contradict one another or the model.
    #[error("{0}")]
    Invalid(String),
    /// A file that cannot be read or written.
    #[error("cannot {doing} {}: {source}", path.display())]
    File {
        /// `read`, `write` or the like.
        doing: &'static str,
        /// Path of the file.
        path: PathBuf,
        /// Error of the file system.
        source: std::io::Error,
    },
    /// A journal of another sweep, or no journal.
    #[error("{} {reason}", path.display())]
    Journal {
        /// Path of the file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// Shards that are not all there, or not whole.
    #[error("{0}")]
    Gaps(String),
    /// A process of several that takes no part.
    #[error("process {process} {reason}")]
    Process {
        /// Its number.
        process: usize,
        /// What it does instead.
        reason: String,
    },
    /// Ctrl-C, before enough was known to be told.
    #[error("interrupted")]
    Interrupted,
    /// Threads that could not be started.
    #[error("cannot start {threads} threads: {reason}")]
    Threads {
        /// Number of threads asked for.
        threads: usize,
        /// Error of the thread pool.
        reason: String,
    },
}

impl SweepError {
    pub(super) fn syntax(text: &str, reason: impl ToString) -> Self {
        Self::Syntax { text: text.trim().to_owned(), reason: reason.to_string() }
    }

    pub(super) fn output(text: &str) -> impl Fn(OutputError) -> Self {
        move |error| Self::syntax(text, error)
    }

    /// Whether the request is invalid, as against a failure on the way.
    pub fn is_mistake(&self) -> bool {
        !matches!(
            self,
            Self::File { .. }
                | Self::Gaps(_)
                | Self::Process { .. }
                | Self::Interrupted
                | Self::Threads { .. }
        )
    }
}

impl From<SweepError> for MotionError {
    fn from(error: SweepError) -> Self {
        Self::Input(error.to_string())
    }
}
