//! Starts from which no motion follows.

use thiserror::Error;

use crate::contact::ContactError;
use crate::error::NameError;
use crate::expression::significant;

/// A start from which no motion follows.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
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
    /// A coordinate that others determine has another value.
    #[error(
        "`{name}` = {value} contradicts the other given values, from which it is {follows}: leave one out"
    )]
    Contradicts {
        /// The coordinate or rate.
        name: String,
        /// Its value.
        value: f64,
        /// What it is by the others.
        follows: f64,
    },
    /// A coordinate is a sum of several that are not given.
    #[error("`{name}` alone does not determine {open}: give all but one of them too")]
    NotDetermined {
        /// The coordinate or rate.
        name: String,
        /// What it is a sum of.
        open: String,
    },
    /// Natural forces or energies are no normal numbers.
    #[error(
        "forces and energies of a motion of {length:.1e} m in {time:.1e} s with {mass:.1e} kg are beyond the range of f64: use other units"
    )]
    Units {
        /// The natural length, m.
        length: f64,
        /// The natural time, s.
        time: f64,
        /// The mass of all bodies, kg.
        mass: f64,
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
    /// A contact with an edge is below it, and is not said to have gone round an end.
    #[error(
        "support {support} is penetrated by {depth:.3e}; if it has passed around an end of its edge, start with `below({name})` = 1"
    )]
    BelowEdge {
        /// The contact.
        support: String,
        /// Its first support.
        name: &'static str,
        /// How deep, > 0.
        depth: f64,
    },
    /// A contact that is said to be below an edge is not.
    #[error(
        "`below({support})` = {value}: use 1 if the support has passed around an end of its edge and is below the edge, else leave it out"
    )]
    NotBelow {
        /// The support.
        support: String,
        /// What it is given as.
        value: f64,
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
    #[error(
        "{joint} cannot close: {} are missing (m, of angles rad), whatever the coordinates that are left open; change the start, or lengths", significant(gap.abs(), 4)
    )]
    Broken {
        /// The joint.
        joint: String,
        /// Its least gap, or the distance of its points.
        gap: f64,
    },
    /// The bars do not reach the pose from the nominal figure without a jump, or by two ways.
    #[error(
        "from the nominal figure no single path of the bars leads to this {given}: give other coordinates, or more of them"
    )]
    Unreached {
        /// The coordinates that are given.
        given: String,
    },
    /// The rates open or close a joint.
    #[error("the rates break {joint} at {speed:.3e}")]
    BreaksJoint {
        /// The joint.
        joint: String,
        /// The rate of its gap.
        speed: f64,
    },
    /// A bar's corner is exactly at the bar's end: whether it bears depends on an infinitesimal
    /// displacement.
    #[error("the contact {support} lies exactly at the {end} point of its bar")]
    AtEnd {
        /// The contact.
        support: String,
        /// `first` or `last`.
        end: &'static str,
    },
    /// Joints hold all coordinates.
    #[error(
        "nothing can move: {constraints} constraints hold all of {coordinates} coordinates; remove a pin or a constraint, or change lengths"
    )]
    Immobile {
        /// How many coordinates there are.
        coordinates: usize,
        /// How many constraints.
        constraints: usize,
    },
    /// At rest without acceleration.
    #[error("the start is an equilibrium: it never moves; start it elsewhere, or with a rate")]
    Equilibrium,
    /// A rate from an energy needs a phase of one degree of freedom.
    #[error("an energy level determines the rate of one degree of freedom, but there are {degrees}")]
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
