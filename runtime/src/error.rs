//! What can go wrong, by stage: the model, the start, a name, the run.

use core::fmt;

use thiserror::Error;

use crate::contact::ContactError;
use crate::integrate::StepError;
use crate::model::BarSystem;
use crate::output::OutputError;
use crate::trajectory::Trajectory;

/// A model that is no mechanical system.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ModelError {
    /// A parameter is infinite or not a number.
    #[error("parameter `{name}` is {value}")]
    Parameter {
        /// The parameter.
        name: String,
        /// Its value.
        value: f64,
    },
    /// A mass, length, inertia or gravity is infinite or not a number.
    #[error("{of} is {value}")]
    NotFinite {
        /// What is measured.
        of: String,
        /// Its value.
        value: f64,
    },
    /// A mass is negative.
    #[error("mass of {of} is negative: {value}")]
    NegativeMass {
        /// The body.
        of: String,
        /// Its mass.
        value: f64,
    },
    /// A moment of inertia is negative.
    #[error("moment of inertia of {of} is negative: {value}")]
    NegativeInertia {
        /// The body.
        of: String,
        /// Its moment of inertia.
        value: f64,
    },
    /// A length is not positive.
    #[error("length of {of} is not positive: {value}")]
    Length {
        /// The bar.
        of: String,
        /// Its length.
        value: f64,
    },
    /// A section lies beyond an end of its bar.
    #[error("{of} lies beyond the end of its bar by {beyond}")]
    OffBar {
        /// The section.
        of: String,
        /// How far, > 0.
        beyond: f64,
    },
    /// The figure gives a coordinate no number.
    #[error("the figure gives `{coordinate}` no number; check the parameters that the figure depends on")]
    Figure {
        /// The coordinate.
        coordinate: String,
    },
    /// The stiffness of a spring is negative.
    #[error("stiffness of {of} is negative: {value}")]
    NegativeStiffness {
        /// The spring.
        of: String,
        /// Its stiffness.
        value: f64,
    },
    /// The damping of a spring is negative.
    #[error("damping of {of} is negative: {value}")]
    NegativeDamping {
        /// The spring.
        of: String,
        /// Its damping.
        value: f64,
    },
    /// A coefficient of restitution is not between 0 and 1.
    #[error("restitution of {contact} is not between 0 and 1: {value}")]
    Restitution {
        /// The contact.
        contact: String,
        /// Its coefficient.
        value: f64,
    },
    /// Nothing has mass.
    #[error("the total mass is zero")]
    Massless,
}

/// A name that the model does not know.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("no {kind} `{name}`{}", suggestion(nearest.as_deref(), known))]
pub struct NameError {
    /// What was looked for: `support`, `coordinate`, `name`.
    pub kind: &'static str,
    /// The name given.
    pub name: String,
    /// The nearest known one, if one is near.
    pub nearest: Option<String>,
    /// All known ones.
    pub known: Vec<String>,
}

/// So many known names are listed where none is near.
const LISTED: usize = 12;

fn suggestion(nearest: Option<&str>, known: &[String]) -> String {
    match nearest {
        Some(nearest) => format!("; did you mean `{nearest}`?"),
        None if known.is_empty() => String::new(),
        None => {
            let more = if known.len() > LISTED { ", …" } else { "" };
            format!("; known: {}{more}", known[..known.len().min(LISTED)].join(", "))
        }
    }
}

/// A support named for holding or releasing, or the time of its release, that makes no sense.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SupportError {
    /// No such support.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A release before the start, or at no time at all.
    #[error("support `{support}` cannot be released at t = {at}")]
    Time {
        /// The support.
        support: String,
        /// The time given.
        at: f64,
    },
}

/// Something planned for a run that makes no sense.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ScheduleError {
    /// No such support, thread or point.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A condition that is none.
    #[error(transparent)]
    Condition(#[from] OutputError),
    /// A support that is no thread cannot be cut.
    #[error("`{support}` is no thread; release it")]
    NoThread {
        /// The support.
        support: String,
    },
    /// A time before the start, or no time at all.
    #[error("nothing can happen at t = {at}")]
    Time {
        /// The time given.
        at: f64,
    },
    /// An impulse that is infinite or not a number.
    #[error("the impulse at {point} is ({}, {})", impulse[0], impulse[1])]
    Impulse {
        /// The point.
        point: String,
        /// The impulse given.
        impulse: [f64; 2],
    },
}

/// A start from which no motion follows.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum StartError {
    /// An unknown coordinate.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A value is infinite or not a number.
    #[error("`{name}` starts at {value}")]
    NotFinite {
        /// The coordinate or rate.
        name: String,
        /// Its value.
        value: f64,
    },
    /// A coordinate is given twice.
    #[error("`{name}` is given twice")]
    Twice {
        /// The coordinate or rate.
        name: String,
    },
    /// A thread is shorter than the distance of its points.
    #[error("thread {thread} is shorter than the distance of its points: its gap is {gap:.3e}")]
    Short {
        /// The thread.
        thread: String,
        /// ℓ − |r|, or (ℓ² − r²)/2ℓ where one segment moves; < 0.
        gap: f64,
    },
    /// A support is penetrated.
    #[error("support {support} is penetrated by {depth:.3e}")]
    Penetrates {
        /// The contact.
        support: String,
        /// How deep, > 0.
        depth: f64,
    },
    /// A bar's corner is beyond the bar's end.
    #[error("the contact {support} lies beyond the end of its bar by {distance:.3e}")]
    OffBar {
        /// The contact.
        support: String,
        /// How far, > 0.
        distance: f64,
    },
    /// A joint or constraint is not satisfied.
    #[error("{joint} is broken by {gap:.3e}")]
    Broken {
        /// The joint.
        joint: String,
        /// Its gap.
        gap: f64,
    },
    /// The rates open or close a joint.
    #[error("the rates break {joint} at {speed:.3e}")]
    BreaksJoint {
        /// The joint.
        joint: String,
        /// The rate of its gap.
        speed: f64,
    },
    /// A bar's corner is exactly at the bar's end: it bears or not by an infinitesimal.
    #[error("the contact {support} lies exactly at the {end} point of its bar")]
    AtEnd {
        /// The contact.
        support: String,
        /// `first` or `last`.
        end: &'static str,
    },
    /// At rest without acceleration.
    #[error("the start is an equilibrium: it never moves")]
    Equilibrium,
    /// A rate from an energy needs a phase of one degree of freedom.
    #[error("an energy level gives the rate of one degree of freedom, here are {degrees}")]
    Degrees {
        /// Degrees of freedom at the start.
        degrees: usize,
    },
    /// The energy level lies below the potential energy of the start.
    #[error("the start lies {missing:.3e} above the energy level")]
    EnergyTooLow {
        /// By how much, > 0.
        missing: f64,
    },
    /// A held support is open.
    #[error("support {support} is held but open by {gap:.3e}")]
    HeldOpen {
        /// The contact.
        support: String,
        /// Its gap.
        gap: f64,
    },
    /// The contact problem has no solution.
    #[error(transparent)]
    Contact(#[from] ContactError),
}

/// Why a run stopped short.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RunCause {
    /// The tolerance is not a number between 0 and 1.
    #[error("tolerance {0} is not between 0 and 1")]
    Tolerance(f64),
    /// The time limit is not positive or not finite.
    #[error("time limit {0} is not a finite time > 0")]
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
    /// Closed loops reach a singular position through which the motion could not be continued.
    #[error("at t = {t}: singular position of the loop through {}", joints.join(", "))]
    Loop {
        /// The joints of the loop.
        joints: Vec<String>,
        /// Time.
        t: f64,
    },
    /// Impacts follow one another ever more quickly, and their end cannot be told.
    #[error("impacts of {} accumulate at t = {t} without converging", contacts.join(", "))]
    Accumulation {
        /// Time.
        t: f64,
        /// Labels of the contacts that are struck.
        contacts: Vec<String>,
    },
    /// Events follow one another without any time between them.
    #[error("events pile up at t = {t}")]
    Stalled {
        /// Time.
        t: f64,
    },
}

/// A run that stopped short, with what had been computed.
pub struct RunError<M: BarSystem> {
    cause: RunCause,
    trajectory: Box<Trajectory<M>>,
}

impl<M: BarSystem> RunError<M> {
    pub(crate) fn new(cause: RunCause, trajectory: Trajectory<M>) -> Self {
        Self { cause, trajectory: Box::new(trajectory) }
    }

    /// Why.
    pub fn cause(&self) -> &RunCause {
        &self.cause
    }

    /// The motion up to there.
    pub fn trajectory(&self) -> &Trajectory<M> {
        &self.trajectory
    }

    /// The motion up to there.
    pub fn into_trajectory(self) -> Trajectory<M> {
        *self.trajectory
    }
}

impl<M: BarSystem> fmt::Debug for RunError<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RunError").field("cause", &self.cause).finish_non_exhaustive()
    }
}

impl<M: BarSystem> fmt::Display for RunError<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the run of {} stopped short: {}", M::LAYOUT.name, self.cause)
    }
}

impl<M: BarSystem> core::error::Error for RunError<M> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        core::error::Error::source(&self.cause)
    }
}
