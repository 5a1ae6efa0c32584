//! Why a run has no second computation.

use thiserror::Error;

/// Why a motion could not be computed once more.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ReplayError {
    /// The run did not start.
    #[error("there is no motion to compute once more")]
    Empty,
    /// Infinitely many impacts: their end is an estimate, and what follows is a model of its own.
    #[error("the impacts that end at t = {t} are infinitely many")]
    Settles {
        /// When they have ended.
        t: f64,
    },
    /// The run passes a singular position of a loop, where its equations do not tell how it goes
    /// on.
    #[error("a loop passes a singular position near t = {t}: derivatives are found up to there only")]
    Singular {
        /// When.
        t: f64,
    },
    /// The equations have no solution of the required accuracy: they are singular, or not smooth.
    #[error("the extrapolation cannot go on before t = {t}")]
    Step {
        /// End of the phase.
        t: f64,
    },
    /// The motion is too long or too stiff for an explicit method.
    #[error("the extrapolation takes too long before t = {t}: the motion is stiff or long")]
    Work {
        /// End of the phase.
        t: f64,
    },
    /// No sign change of the guard that ended a phase was found near its end.
    #[error("the event at t = {t} is not found again")]
    Event {
        /// When.
        t: f64,
    },
    /// What decides an event only touches zero: its time has no derivative.
    #[error("the event at t = {t} is grazing: its time has no derivative")]
    Grazing {
        /// When.
        t: f64,
    },
    /// Events at one time that come apart with what is varied, or an event at a given time beside
    /// one whose time varies: which of them is first depends on the way.
    #[error("events at t = {t} separate: only one-sided derivatives exist after them")]
    Simultaneous {
        /// When.
        t: f64,
    },
    /// A condition that cannot be evaluated on these numbers.
    #[error("the condition at t = {t} needs {feature}, which are known in double precision only")]
    Condition {
        /// When.
        t: f64,
        /// The feature that is known in double precision only.
        feature: &'static str,
    },
    /// An output that cannot be evaluated on these numbers.
    #[error("`{output}` needs {feature}, which are known in double precision only")]
    Output {
        /// The output.
        output: String,
        /// The feature that is known in double precision only.
        feature: &'static str,
    },
    /// Something is to be read at a time that the run does not have.
    #[error("t = {t} is not within the run")]
    Outside {
        /// When.
        t: f64,
    },
    /// A phase of the run begins in a state that its equations do not have: the run has jumped.
    #[error("the phase from t = {t} does not begin where the one before it ends")]
    Jump {
        /// When.
        t: f64,
    },
    /// No law of impact gives the rates of the run.
    #[error("the impact at t = {t} is not found again")]
    Impact {
        /// When.
        t: f64,
    },
}
