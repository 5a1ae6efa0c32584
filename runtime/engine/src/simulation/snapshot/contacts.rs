//! What each contact is during a run, and what may become of it:
//!
//! ```text
//!            arm                    decide
//!   absent ───────▶ open, waiting ─────────▶ closed
//!      ▲  ◀───────    ▲   │  ▲   ◀─────────    │
//!      │   remove     └── below ──┘  open      │
//!      └──────────────── remove ───────────────┘
//! ```
//!
//! A drive waits for what it drives to come. A contact is below its ground where it has come there
//! from beyond the end of its bar, or has been armed there; it closes only after it has come back.

use crate::model::{ContactSet, Layout};

/// What a contact is.
#[cfg(test)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ContactState {
    /// It has been taken away, or its condition does not hold.
    Absent,
    /// A drive that has not taken hold.
    Waiting,
    /// Open and below its ground.
    Below,
    /// Open.
    Open,
    /// Closed as long as its reaction pushes.
    Closed,
    /// Closed whatever its reaction.
    Held,
}

/// The states of all contacts; of the closed ones how they slip too.
#[derive(Debug)]
pub(crate) struct Contacts {
    closed: ContactSet,
    /// Those to be held wherever they are closed.
    held: ContactSet,
    absent: ContactSet,
    below: ContactSet,
    drives: ContactSet,
    guides: ContactSet,
}

impl Contacts {
    /// At a start that touches some. Drives among them have taken hold, and `held` are held.
    pub(crate) fn new(layout: &Layout, touching: ContactSet, held: ContactSet, absent: ContactSet) -> Self {
        let (drives, guides) = (layout.drives(), layout.guides());
        let held = held.union(touching.intersection(drives));
        Self { closed: touching.difference(absent), held, absent, below: ContactSet::EMPTY, drives, guides }
    }

    /// What a contact is.
    #[cfg(test)]
    pub(crate) fn state(&self, contact: usize) -> ContactState {
        let is = |set: ContactSet| set.contains(contact);
        match contact {
            _ if is(self.absent) => ContactState::Absent,
            _ if is(self.closed) && is(self.held) => ContactState::Held,
            _ if is(self.closed) => ContactState::Closed,
            _ if is(self.drives) => ContactState::Waiting,
            _ if is(self.below) => ContactState::Below,
            _ => ContactState::Open,
        }
    }

    /// Those that are closed, and how they slip.
    pub(crate) fn closed(&self) -> ContactSet {
        self.closed
    }

    /// Those that are held wherever they are closed.
    pub(crate) fn held(&self) -> ContactSet {
        self.held.difference(self.absent)
    }

    /// Those that are not there.
    pub(crate) fn absent(&self) -> ContactSet {
        self.absent
    }

    /// The open ones below their grounds.
    pub(crate) fn below(&self) -> ContactSet {
        self.below
    }

    /// Those that are closed always, unless they have been taken away.
    pub(crate) fn guides(&self) -> ContactSet {
        self.guides.difference(self.absent)
    }

    /// The drives that wait for what they drive to come.
    pub(crate) fn waiting(&self) -> ContactSet {
        self.drives.difference(self.closed)
    }

    /// A decision: these are closed, and no others.
    pub(crate) fn decide(&mut self, closed: ContactSet) {
        debug_assert!(closed.intersection(self.absent).is_empty(), "closed contacts are there");
        self.closed = closed;
        self.below = self.below.difference(closed);
    }

    /// The drives of a set take hold.
    pub(crate) fn take_hold(&mut self, set: ContactSet) {
        self.held = self.held.union(set.intersection(self.drives));
    }

    /// Contacts open before the next decision.
    pub(crate) fn open(&mut self, set: ContactSet) {
        self.closed = self.closed.difference(set);
    }

    /// Corners slide off the ends of their bars; nothing holds them any more.
    pub(crate) fn slide_off(&mut self, set: ContactSet) {
        self.open(set);
        self.held = self.held.difference(set);
    }

    /// Contacts are taken away.
    pub(crate) fn remove(&mut self, set: ContactSet) {
        self.open(set);
        self.absent = self.absent.union(set);
    }

    /// The conditions of contacts hold no longer. Drives among them wait when they are armed again.
    pub(crate) fn disarm(&mut self, set: ContactSet) {
        self.remove(set);
        self.held = self.held.difference(set.intersection(self.drives));
    }

    /// The conditions of contacts have come to hold: they are there, and open.
    pub(crate) fn arm(&mut self, set: ContactSet) {
        self.absent = self.absent.difference(set);
    }

    /// The open contacts that are below their grounds from now on.
    pub(crate) fn set_below(&mut self, set: ContactSet) {
        self.below = set;
    }
}

#[cfg(test)]
mod tests {
    use super::{ContactState, Contacts};
    use crate::model::ContactSet;

    /// A support, a drive and a corner, of which the support is closed.
    fn contacts() -> Contacts {
        let [closed, drives] = [0b001, 0b010].map(ContactSet::from_bits);
        let none = ContactSet::EMPTY;
        Contacts { closed, held: none, absent: none, below: none, drives, guides: none }
    }

    fn states(contacts: &Contacts) -> [ContactState; 3] {
        [0, 1, 2].map(|contact| contacts.state(contact))
    }

    #[test]
    fn absent_contacts_are_neither_closed_nor_held_nor_waiting() {
        use ContactState::{Absent, Closed, Held, Open, Waiting};
        let mut contacts = contacts();
        assert_eq!(states(&contacts), [Closed, Waiting, Open]);
        contacts.take_hold(ContactSet::from_bits(0b111));
        contacts.decide(ContactSet::from_bits(0b011));
        // Of what closes only drives take hold.
        assert_eq!(states(&contacts), [Closed, Held, Open]);
        contacts.disarm(ContactSet::from_bits(0b011));
        assert_eq!(states(&contacts), [Absent, Absent, Open]);
        assert!(contacts.held().is_empty() && contacts.closed().is_empty());
        contacts.arm(ContactSet::from_bits(0b011));
        assert_eq!(states(&contacts), [Open, Waiting, Open]);
    }

    #[test]
    fn a_held_support_is_held_again_after_it_was_away_but_not_after_it_slid_off() {
        use ContactState::{Below, Closed, Held, Open};
        let support = ContactSet::from_bits(0b001);
        let mut contacts = Contacts { held: support, ..contacts() };
        assert_eq!(contacts.state(0), Held);
        contacts.remove(support);
        contacts.arm(support);
        assert_eq!(contacts.state(0), Open);
        contacts.decide(support);
        assert_eq!(contacts.state(0), Held);
        contacts.slide_off(support);
        contacts.set_below(support);
        assert_eq!(contacts.state(0), Below);
        contacts.set_below(ContactSet::EMPTY);
        contacts.decide(support);
        assert_eq!(contacts.state(0), Closed);
    }
}
