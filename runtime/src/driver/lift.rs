//! Contacts that open because their reaction reaches zero: what they do at first is known, and a flight too low to be
//! seen is no flight.
//!
//! A gap that opens so starts with g = ġ = g̈ = 0 < g⃛. Where it closes again without ever having been above its error
//! bound, the tolerance does not tell a flight from a touch: the run goes back to the opening, calls it a touch that is
//! undecided, and keeps the contact closed while its reaction is below zero.

use super::Driver;
use crate::event::EventKind;
use crate::model::{BarSystem, ContactSet};

/// The note of a touch that may have been an opening.
pub(super) const UNDECIDED: &str = "undecided";

/// Derivatives of the gap that vanish with a reaction at zero are those below this one.
const ORDER: usize = 3;

/// The run as it was when contacts opened.
pub(super) struct Lift<M: BarSystem> {
    opened: ContactSet,
    t: f64,
    state: M::State<f64>,
    touching: ContactSet,
    closed: ContactSet,
    reactions: Vec<f64>,
    events: usize,
    pieces: usize,
}

impl<M: BarSystem> Lift<M> {
    /// The same, of these contacts.
    pub(super) fn of(self, opened: ContactSet) -> Self {
        Self { opened, ..self }
    }
}

impl<M: BarSystem> Driver<'_, M> {
    pub(super) fn before_lift(&self) -> Lift<M> {
        Lift {
            opened: ContactSet::EMPTY,
            t: self.t,
            state: self.state,
            touching: self.closed,
            closed: self.closed,
            reactions: self.reactions.clone(),
            events: self.trajectory.events.len(),
            pieces: self.trajectory.pieces.len(),
        }
    }

    /// Gaps of contacts that have just opened, with the order of their first derivative that is not zero.
    pub(super) fn orders(&self) -> Vec<(usize, usize)> {
        let opened = self.lift.as_ref().map_or(ContactSet::EMPTY, |lift| lift.opened);
        opened.iter().map(|i| (i, ORDER)).collect()
    }

    /// Takes back an opening that was followed at once by closing, `unseen` in between; whether it did.
    pub(super) fn take_back(&mut self, unseen: ContactSet) -> bool {
        let Some(lift) = self.lift.take().filter(|lift| lift.opened.0 & !unseen.0 == 0) else { return false };
        let Lift { opened, t, state, touching, closed, reactions, events, pieces } = lift;
        (self.t, self.state, self.touching, self.closed) = (t, state, touching, closed);
        self.reactions = reactions;
        self.trajectory.events.truncate(events);
        self.trajectory.pieces.truncate(pieces);
        self.trajectory.ends.truncate(pieces);
        self.lenient = ContactSet(self.lenient.0 | opened.0);
        self.choose_form();
        self.record(EventKind::Touch, opened, Some(UNDECIDED.to_owned()));
        true
    }

    /// Contacts whose reaction has come back are watched again.
    pub(super) fn end_leniency(&mut self) {
        let closed = self.closed;
        let below = |i: &usize| closed.contains(*i) && self.reactions[*i] <= 0.0;
        self.lenient = self.lenient.iter().filter(below).fold(ContactSet::EMPTY, ContactSet::with);
    }
}
