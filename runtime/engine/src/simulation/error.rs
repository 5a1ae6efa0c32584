//! Runs that stopped short.

use core::fmt;

use thiserror::Error;

use super::Exhausted;
use crate::assembly::StartError;
use crate::audit::Finding;
use crate::contact::ContactError;
use crate::expression::Condition;
use crate::integrate::StepError;
use crate::trajectory::Trajectory;

/// Why a run stopped short.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum RunCause {
    /// The tolerance is not a number between 0 and 1.
    #[error("tolerance {0} is not between 0 and 1")]
    Tolerance(f64),
    /// The time limit is not finite, or not after the start.
    #[error("time limit {0} is not a finite time after the start")]
    Limit(f64),
    /// The start allows no motion.
    #[error(transparent)]
    Start(#[from] StartError),
    /// The contacts allow no motion.
    #[error("at t = {t}: {source}")]
    Contact {
        /// Time.
        t: f64,
        /// The contact problem.
        source: ContactError,
    },
    /// The integrator cannot go on.
    #[error(transparent)]
    Step(#[from] StepError),
    /// A prescribed motion is not smooth: the force of the drive would be infinite.
    #[error(
        "at t = {t}: the prescribed motion `{expression}` {what}; end the run before, or prescribe a smooth motion"
    )]
    Drive {
        /// Time.
        t: f64,
        /// What is prescribed, as a function of time.
        expression: &'static str,
        /// What it does there.
        what: &'static str,
    },
    /// Closed loops reach a singular position through which the motion could not be continued.
    #[error("at t = {t}: singular position of the loop through {}", joints.join(", "))]
    Loop {
        /// The joints of the loop.
        joints: Vec<String>,
        /// Time.
        t: f64,
    },
    /// Impacts accumulate, and the time at which they end cannot be determined.
    #[error("impacts of {} accumulate at t = {t} without converging", contacts.join(", "))]
    Accumulation {
        /// Time.
        t: f64,
        /// Labels of the contacts that are struck.
        contacts: Vec<String>,
    },
    /// Contacts or joints hold at a state that does not satisfy them: the motion would have to
    /// jump.
    #[error("at t = {t}: to keep {} closed the state would have to jump by {by:.1e} of its size", contacts.join(", "))]
    Jump {
        /// Time.
        t: f64,
        /// Labels of the contacts, or of the joints where there are none.
        contacts: Vec<String>,
        /// The largest change, in natural units, relative to the largest entry where that is above
        /// one.
        by: f64,
    },
    /// The motion breaks what every motion satisfies; what was computed up to there is not to be
    /// trusted near its end.
    #[error("{0}")]
    Invariant(Finding),
    /// It takes more than its budget, see [`Simulation::budget`](crate::Simulation::budget).
    #[error("at t = {t}: the run has taken its budget of {of}")]
    Budget {
        /// How far it has come.
        t: f64,
        /// Of what.
        of: Exhausted,
    },
    /// It was asked to stop, see [`Simulation::cancel`](crate::Simulation::cancel).
    #[error("interrupted at t = {t}")]
    Cancelled {
        /// How far it has come.
        t: f64,
    },
    /// Chattering: what a condition switches on makes it false, and true once it is off.
    #[error(
        "chattering at t = {t}: `{condition}` switches {of}, which switches `{condition}` back; add hysteresis (other values for \
         on and off), or let it follow the motion smoothly"
    )]
    Chatter {
        /// Time.
        t: f64,
        /// The springs and loads, or the contact or drive.
        of: String,
        /// Their condition.
        condition: Box<Condition>,
    },
    /// A distance is driven to zero or below.
    #[error(
        "at t = {t}: `drive({drive} = …)` comes to zero, where a distance has no direction, and none is negative; let it end before by \
         `while(\"…\")`, or drive a coordinate or `along(POINT, BAR)`, which have a sign"
    )]
    DrivenDistance {
        /// Time.
        t: f64,
        /// What is driven, `distance(A, B)`.
        drive: String,
    },
    /// A coefficient of friction that depends on the slip velocity becomes negative: friction would
    /// drive the motion.
    #[error(
        "at t = {t}: friction of {contact} becomes negative at the slip velocity {velocity}; let its expression of `v` stay above zero, \
         as `mu / (1 + c * v * v)` does"
    )]
    NegativeFriction {
        /// Time.
        t: f64,
        /// Label of the contact.
        contact: String,
        /// The slip velocity.
        velocity: f64,
    },
    /// Events follow one another without any time between them.
    #[error(
        "no progress at t = {t}: repeated events{}. The outcome depends on roundoff; try another tolerance or a slightly different start",
        of_contacts(contacts)
    )]
    Stalled {
        /// Time.
        t: f64,
        /// Labels of the contacts whose reactions, gaps, slips or limits are at zero there.
        contacts: Vec<String>,
    },
}

fn of_contacts(contacts: &[String]) -> String {
    if contacts.is_empty() { String::new() } else { format!(" of {}", contacts.join(", ")) }
}

/// A run that stopped short, with what had been computed.
pub struct RunError {
    cause: RunCause,
    trajectory: Box<Trajectory>,
}

impl RunError {
    pub(crate) fn new(cause: RunCause, trajectory: Trajectory) -> Self {
        Self { cause, trajectory: Box::new(trajectory) }
    }

    /// Why.
    pub fn cause(&self) -> &RunCause {
        &self.cause
    }

    /// The motion up to there.
    pub fn trajectory(&self) -> &Trajectory {
        &self.trajectory
    }

    /// The motion up to there.
    pub fn into_trajectory(self) -> Trajectory {
        *self.trajectory
    }
}

impl fmt::Debug for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RunError").field("cause", &self.cause).finish_non_exhaustive()
    }
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the run of {} stopped short: {}", self.trajectory.layout().name, self.cause)
    }
}

impl core::error::Error for RunError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        core::error::Error::source(&self.cause)
    }
}
