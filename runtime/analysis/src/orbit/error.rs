//! Why there is no periodic orbit.

use liftoff::{OutputError, SupportError};
use thiserror::Error;

use crate::SensitivityError;

/// Why a periodic orbit is not found or not followed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum OrbitError {
    /// The section names an event of a support that is not there.
    #[error("section: {0}")]
    Event(#[from] SupportError),
    /// The section is neither an event nor a condition.
    #[error("section `{text}`: neither a kind of event with or without a support, nor a condition: {why}")]
    Section {
        /// As it was given.
        text: String,
        /// What is wrong with it as a condition.
        why: OutputError,
    },
    /// A run is refused or stops short.
    #[error("{0}")]
    Run(String),
    /// The motion does not come to the section.
    #[error("the motion does not reach the section `{section}`: it ends with `{last}`")]
    NoReturn {
        /// The section.
        section: String,
        /// The event that ended it.
        last: String,
    },
    /// The section is met at once however often the run is started from it.
    #[error("from the section `{section}` every run meets it again at once: choose another section")]
    NoStart {
        /// The section.
        section: String,
    },
    /// Contacts and drifting coordinates hold all of the start.
    #[error(
        "on the section `{section}` no direction is free: the contacts and the drift fix the whole state"
    )]
    Held {
        /// The section.
        section: String,
    },
    /// The return has no derivatives.
    #[error(transparent)]
    Sensitivity(#[from] SensitivityError),
    /// Newton's method does not come to a fixed point.
    #[error(
        "no fixed point of the return map from this start: after {iterations} iterations the state differs from its image by {residual:.1e} natural units at {state}"
    )]
    NotFound {
        /// How many.
        iterations: usize,
        /// By how much, in natural units.
        residual: f64,
        /// The state reached, `phi = 0.1, …`.
        state: String,
    },
    /// The fixed point is no motion.
    #[error(
        "the fixed point of the return map is an equilibrium: start farther from it, or choose a section that is crossed one way, `phi > 0`"
    )]
    AtRest,
    /// Orbits with the same parameters lie side by side, so that none is followed from one
    /// parameter to the next.
    #[error(
        "the orbit is one of a family with the same parameters, as where energy is conserved: the orbit to follow is not determined"
    )]
    Family,
    /// What drifts does not do so by a symmetry: from the shifted state the motion is another.
    #[error(
        "after one more period {entry} differs by {apart:.1e} natural units: the motion depends on the drifting coordinate"
    )]
    NotEquivariant {
        /// A coordinate or rate.
        entry: String,
        /// By how much, in natural units.
        apart: f64,
    },
}
