//! Which contacts are closed: the complementarity problem at acceleration level with its degenerate
//! cases, and at impulse level.

mod active_rows;
mod closed_rows;
mod complementarity;
mod degenerate;
mod equations;
mod equilibrated_kkt;
pub(crate) mod friction;
mod groups;
pub(crate) mod hinges;
mod impact;
pub mod impulse;
mod joint_impulse;
mod kinetic_angle;
mod laws;
mod least_constraint;
pub(crate) mod nondegenerate;
mod residual;
mod shares;
mod single_impact;
mod singular;
mod stationary_gap;
#[cfg(test)]
mod tests;
mod trials;

pub(crate) use active_rows::ActiveRows;
#[cfg(test)]
pub(crate) use degenerate::decide;
pub(crate) use degenerate::{Alternatives, ContactProblem, ContactSolution};
pub use friction::impact::path::{Path, RouthContact, Vertex};
pub(crate) use joint_impulse::compute_joint_impulse;
pub(crate) use laws::Laws;
pub(crate) use shares::shortest_reactions;
pub(crate) use single_impact::ReducedCollision;
pub(crate) use singular::{are_determined, refuse_singular, singular};
pub(crate) use stationary_gap::StationaryGaps;
pub(crate) use trials::Trials;

use thiserror::Error;

use crate::model::{ContactSet, Layout, SlipState};

/// Why no motion follows from a state.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ContactError {
    /// No admissible reactions exist: the supports and joints contradict each other.
    #[error("jammed: no reactions of {} satisfy the contact conditions", contacts.join(", "))]
    Jammed {
        /// Labels of the contacts that act, or of the joints where none does.
        contacts: Vec<String>,
    },
    /// No admissible impulses exist at an impact.
    #[error("no impulses of {} satisfy the contact conditions", contacts.join(", "))]
    Impulses {
        /// Labels of the contacts that act.
        contacts: Vec<String>,
    },
    /// The accelerations are not determined by the equations of motion.
    #[error(
        "singular: the mass matrix does not determine the accelerations with {} closed{}",
        closed(contacts),
        without_inertia(coordinates, massless)
    )]
    Singular {
        /// Labels of the contacts that act.
        contacts: Vec<String>,
        /// The coordinates that can move together without moving a mass.
        coordinates: Vec<String>,
        /// What has no mass.
        massless: Vec<String>,
    },
    /// Stronge's law relates energies of one contact, and several act at once.
    #[error("Stronge's restitution applies to one contact at a time, but {} act at once", contacts.join(", "))]
    Several {
        /// Labels of the contacts that act.
        contacts: Vec<String>,
    },
    /// More sets of contacts would have to be tried than [`Budget::trials`](crate::Budget::trials)
    /// allows.
    #[error("too many sets of {} to be tried", contacts.join(", "))]
    Undecided {
        /// Labels of the contacts that act.
        contacts: Vec<String>,
    },
    /// Friction in hinges leaves no motion: the couples of journals that are large against their
    /// bodies turn back on the forces that press them.
    #[error("hinge friction at {} has no unique solution: μ · radius of their journals is too large", hinges.join(", "))]
    Hinges {
        /// Labels of the hinges.
        hinges: Vec<String>,
    },
    /// A coefficient of friction that depends on the slip velocity is negative.
    #[error("friction of {contact} is negative at this slip velocity: {value}")]
    NegativeFriction {
        /// Label of the contact.
        contact: String,
        /// The coefficient.
        value: f64,
    },
    /// Masses, forces or rates are so large that their products overflow.
    #[error("the equations of motion are not finite")]
    NotFinite,
}

/// Refuses a coefficient of friction of a touching contact that is negative at these slips.
fn refuse_negative_friction(
    layout: &Layout,
    slips: &[SlipState<f64>],
    touching: ContactSet,
) -> Result<(), ContactError> {
    let negative = layout.frictions.iter().zip(slips).find(|(friction, slip)| {
        touching.contains(friction.contact) && (slip.kinetic.is_nan() || slip.kinetic < 0.0)
    });
    negative.map_or(Ok(()), |(friction, slip)| {
        let contact = layout.contacts[friction.contact].label.to_owned();
        Err(ContactError::NegativeFriction { contact, value: slip.kinetic })
    })
}

/// The labels of the contacts of a set.
pub(crate) fn labels(layout: &Layout, set: ContactSet) -> Vec<String> {
    set.iter().map(|i| layout.contacts[i].label.to_owned()).collect()
}

/// The names of the joints, which an error is about where no contact acts.
pub(crate) fn joint_names(layout: &Layout) -> Vec<String> {
    layout.joints.iter().map(|joint| joint.name.to_owned()).collect()
}

fn closed(contacts: &[String]) -> String {
    if contacts.is_empty() { "no contact".to_owned() } else { contacts.join(", ") }
}

fn without_inertia(coordinates: &[String], massless: &[String]) -> String {
    match (coordinates, massless) {
        ([], _) => String::new(),
        (_, []) => format!(": no mass resists {}", coordinates.join(", ")),
        _ => format!(": no mass resists {} (without mass: {})", coordinates.join(", "), massless.join(", ")),
    }
}
