//! How a contact stands, as importers see it.

use liftoff_core::model::{Contact, ContactSet, Slip};

/// How a contact stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactState {
    /// It bears nothing.
    Open = 0,
    /// It is closed, and has no friction.
    Closed = 1,
    /// It is closed and does not slip.
    Sticking = 2,
    /// It is closed and slips along its tangent.
    Forward = 3,
    /// It is closed and slips against its tangent.
    Backward = 4,
}

impl ContactState {
    /// All of them, in the order of their values.
    pub const ALL: [Self; 5] = [Self::Open, Self::Closed, Self::Sticking, Self::Forward, Self::Backward];

    /// That of a contact in a contact set.
    pub fn new(set: ContactSet, index: usize, contact: &Contact) -> Self {
        match set.slip(index) {
            _ if !set.contains(index) => Self::Open,
            _ if contact.rough => Self::Sticking,
            _ if contact.friction.is_none() => Self::Closed,
            Slip::Stick => Self::Sticking,
            Slip::Forward => Self::Forward,
            Slip::Backward => Self::Backward,
        }
    }

    /// Its name in descriptions.
    pub fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Closed => "closed",
            Self::Sticking => "sticking",
            Self::Forward => "sliding forward",
            Self::Backward => "sliding backward",
        }
    }
}
