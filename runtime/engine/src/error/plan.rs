//! What is planned for a run.

use thiserror::Error;

use super::{NameError, OutputError};

/// An unknown support to hold or release, or an invalid time of its release.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SupportError {
    /// No such support.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A time of release that is negative, infinite or not a number.
    #[error("support `{support}` cannot be released at t = {at}")]
    Time {
        /// The support.
        support: String,
        /// The time given.
        at: f64,
    },
    /// Friction of a held contact would drive the motion where the reaction pulls.
    #[error(
        "support `{support}` has friction and cannot be held: where it pulls, its friction would drive the motion; declare a slider"
    )]
    HeldWithFriction {
        /// The support.
        support: String,
    },
}

/// An invalid scheduled action.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ScheduleError {
    /// No such support, thread or point.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A condition that cannot be parsed.
    #[error(transparent)]
    Condition(#[from] OutputError),
    /// A support that is no thread cannot be cut.
    #[error("`{support}` is not a thread; release it")]
    NoThread {
        /// The support.
        support: String,
    },
    /// A time that is negative, infinite or not a number.
    #[error("nothing can happen at t = {at}")]
    Time {
        /// The time given.
        at: f64,
    },
    /// The impulse that a hinge with friction passes on would not be known.
    #[error(
        "no impulse can be applied to a model with friction in hinges: hinge impulses would depend on it; use an impact instead"
    )]
    HingeFriction,
    /// An impulse that is infinite or not a number.
    #[error("the impulse at {point} is ({}, {})", impulse[0], impulse[1])]
    Impulse {
        /// The point.
        point: String,
        /// The impulse given.
        impulse: [f64; 2],
    },
}
