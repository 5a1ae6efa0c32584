//! Why a motion has no reference.

use liftoff_replay::ReplayError;
use thiserror::Error;

/// Why a motion could not be computed once more in double-double.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ReferenceError {
    /// It could not be computed once more.
    #[error(transparent)]
    Replay(#[from] ReplayError),
    /// It is beyond the judge.
    #[error("not judged: {why}")]
    NotJudged {
        /// Why.
        why: String,
    },
    /// The judge finds an event that the run does not have.
    #[error("the event that the judge finds at t = {t} is missed")]
    Missed {
        /// When.
        t: f64,
    },
    /// Two tolerances differ by more than doubles resolve.
    #[error("the reference is known to {bound:.0e} only")]
    Bound {
        /// Their difference.
        bound: f64,
    },
}
