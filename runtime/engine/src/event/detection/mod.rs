//! The guards of a phase over one step: reactions of closed contacts, gaps of open ones, feet of
//! closed corners, of contacts with friction the limits of those that stick and the slip velocities
//! of those that slide, and the conditions that are waited for.

mod advance;
mod affine;
mod contact_status;
mod detector;
mod friction_work;
mod guard_source;
mod guards;
mod sample;
mod sampled_step;
mod samples;
mod signals;
mod step;

#[cfg(test)]
mod tests;

pub(crate) use affine::{AffineGuards, KnownAffineGuards};
pub(crate) use contact_status::ContactStatus;
pub(crate) use detector::EventDetector;
pub(crate) use signals::{Broken, Signal, Signals, Unseen};
pub(crate) use step::StepView;

use crate::model::{Side, Slip};

/// A piece of a step is divided down to this length at most: poles are never resolved.
const SHORTEST: f64 = 1e-12;

/// The fraction of a flight's height that counts as zero.
pub(crate) const LOW: f64 = 1.0 / 64.0;

/// What is watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Guard {
    /// The reaction of a closed contact.
    Reaction(usize),
    /// s N of a guide with friction that presses to a side: at zero it changes the side.
    Side(usize, Side),
    /// The gap of an open contact.
    Gap(usize),
    /// Negated gap of a redundant closed contact; negative once it is no longer redundant.
    RedundantGap(usize),
    /// A foot of a contact: how far it is from the end of its bar.
    Foot {
        /// The contact.
        contact: usize,
        /// The entry of the model's feet.
        entry: usize,
    },
    /// μₛ |N| + σ R of a contact that sticks: at zero it begins to slide with the sense σ.
    Limit(FrictionGuard),
    /// How far contacts that share their load are from slipping together.
    SharedFriction,
    /// σ v of a contact that slides with the sense σ: at zero it stops.
    Slip(FrictionGuard),
    /// A condition that ends the run or starts something planned.
    Condition(usize),
}

/// A contact with friction, and a sense in which it slides or may slide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FrictionGuard {
    /// The contact.
    pub contact: usize,
    /// The entry of the model's frictions.
    pub friction: usize,
    /// The sense.
    pub slip: Slip,
    /// The side that it presses to.
    pub side: Side,
}

impl Guard {
    /// The contact whose gap it is, if it is one.
    pub(crate) fn gap(self) -> Option<usize> {
        if let Self::Gap(contact) = self { Some(contact) } else { None }
    }

    /// The contact that it watches, if it is of one.
    pub(crate) fn contact(&self) -> Option<usize> {
        match *self {
            Self::Reaction(contact)
            | Self::Side(contact, _)
            | Self::Gap(contact)
            | Self::RedundantGap(contact) => Some(contact),
            Self::Foot { contact, .. }
            | Self::Limit(FrictionGuard { contact, .. })
            | Self::Slip(FrictionGuard { contact, .. }) => Some(contact),
            Self::SharedFriction | Self::Condition(_) => None,
        }
    }
}

/// Error bounds of the guards, relative to natural scales.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GuardBounds {
    pub(crate) relative: f64,
    pub(crate) length: f64,
}

/// What happens in a step.
#[derive(Debug, Default)]
pub(crate) struct StepEvents {
    /// Guards that touch zero, before the first event.
    pub(crate) touches: Vec<(f64, Guard)>,
    /// The first event, and all guards that are within their bound of zero there.
    pub(crate) first: Option<(f64, Vec<Guard>)>,
}
