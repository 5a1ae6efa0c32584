//! Why a motion has no reference.

use thiserror::Error;

/// Why a motion could not be computed once more in double-double.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ReferenceError {
    /// The run did not start.
    #[error("there is no motion to compute once more")]
    Empty,
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
    /// Infinitely many impacts: their end is an estimate, and what follows is a model of its own.
    #[error("the impacts that end at t = {t} are infinitely many")]
    Settles {
        /// When they have ended.
        t: f64,
    },
    /// The equations have no solution of the required accuracy: they are singular, or not smooth.
    #[error("the extrapolation cannot go on before t = {t}")]
    Step {
        /// End of the phase.
        t: f64,
    },
    /// The motion is too long or too stiff for an explicit method in double-double.
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
    /// A condition that cannot be evaluated in double-double.
    #[error("the condition at t = {t} asks for {feature}, which have no double-double form")]
    Condition {
        /// When.
        t: f64,
        /// The functions that have no double-double form.
        feature: &'static str,
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
    /// Two tolerances differ by more than doubles resolve.
    #[error("the reference is known to {bound:.0e} only")]
    Bound {
        /// Their difference.
        bound: f64,
    },
}
