//! Contacts as the run treats them.

use crate::contact::friction::SharedFriction;
use crate::model::ContactSet;

/// Contacts as the run treats them.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ContactStatus<'a> {
    /// Closed contacts: those that bear, and those that depend on them.
    pub(crate) closed: ContactSet,
    pub(crate) held: ContactSet,
    pub(crate) removed: ContactSet,
    /// Open contacts at the ends of their bars or beyond, and open ones below their grounds: what
    /// of them is not above closes only after it has come back.
    pub(crate) below: ContactSet,
    /// Closed contacts whose reaction or slip velocity is zero, or whose friction force is at its
    /// limit, and that have just been decided to go on as they are.
    pub(crate) suppressed: ContactSet,
    /// Closed contacts with friction that share their load.
    pub(crate) shared_friction: SharedFriction,
    /// Heights that bouncing contacts are to reach.
    pub(crate) heights: &'a [(usize, f64)],
    /// Gaps that are zero at the start, each with the order of its first nonzero derivative.
    pub(crate) orders: &'a [(usize, usize)],
    /// The size of each reaction.
    pub(crate) forces: &'a [f64],
    /// The natural slip velocity of each contact with friction.
    pub(crate) slips: &'a [f64],
}

impl ContactStatus<'_> {
    /// The height that a contact is to reach, infinite where nothing is known of it.
    pub(super) fn height(&self, contact: usize) -> f64 {
        self.heights.iter().find(|(known, _)| *known == contact).map_or(f64::INFINITY, |(_, height)| *height)
    }
}
