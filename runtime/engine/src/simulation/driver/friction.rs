//! Contacts with friction: what is known of their slips before a decision, and the events that it makes.

use super::Driver;
use crate::contact::friction::{Reason, Sense, Slip as KnownSlip};
use crate::event::detection::{Guard, Rub};
use crate::event::{EventKind, FrictionState, Note};
use crate::model::{ContactSet, Slip, SlipState};

/// What has been located of contacts with friction at an event.
#[derive(Debug, Clone, Default)]
pub(super) struct LocatedSlips {
    /// Contacts that stuck and have reached their limits.
    leaving: Vec<Rub>,
    /// Contacts that slid and have stopped.
    stopped: Vec<Rub>,
}

impl LocatedSlips {
    pub(super) fn of(guards: &[Guard]) -> Self {
        let leaving = guards.iter().filter_map(|g| if let Guard::Limit(rub) = g { Some(*rub) } else { None });
        let stopped = guards.iter().filter_map(|g| if let Guard::Slip(rub) = g { Some(*rub) } else { None });
        Self { leaving: leaving.collect(), stopped: stopped.collect() }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.leaving.is_empty() && self.stopped.is_empty()
    }

    /// The contacts.
    pub(super) fn contacts(&self) -> ContactSet {
        self.leaving.iter().chain(&self.stopped).map(|rub| rub.contact).collect()
    }
}

impl Driver<'_> {
    /// What is known of the slip of each touching contact with friction: what was located, how it slipped in the phase
    /// before, else what its velocity says.
    pub(super) fn known_slips(&self, located: &LocatedSlips) -> Vec<(usize, KnownSlip)> {
        let layout = self.layout();
        if layout.frictions.is_empty() {
            return Vec::new();
        }
        let slips = self.slip_states();
        let scales = &self.setup.context.scales;
        let bound = self.relative_bound() * scales.length / scales.time;
        let touching = layout.frictions.iter().enumerate();
        let touching = touching.filter(|(_, friction)| self.touching.contains(friction.contact));
        let known = touching.map(|(k, friction)| {
            let contact = friction.contact;
            let leaves = located.leaving.iter().find(|rub| rub.contact == contact);
            let stops = located.stopped.iter().any(|rub| rub.contact == contact);
            let velocity = slips[k].velocity;
            let known = match leaves {
                Some(rub) if rub.slip == Slip::Backward => KnownSlip::Leaves(Sense::Backward),
                Some(_) => KnownSlip::Leaves(Sense::Forward),
                None if stops => KnownSlip::Rest,
                None if self.sensed.contains(contact) => match self.touching.slip(contact) {
                    Slip::Stick => KnownSlip::Rest,
                    Slip::Forward => KnownSlip::Forward,
                    Slip::Backward => KnownSlip::Backward,
                },
                None if velocity.abs() <= bound => KnownSlip::Rest,
                None if velocity > 0.0 => KnownSlip::Forward,
                None => KnownSlip::Backward,
            };
            (contact, known)
        });
        known.collect()
    }

    fn slip_states(&self) -> Vec<SlipState<f64>> {
        let zero = SlipState { velocity: 0.0, kinetic: 0.0, limit: 0.0 };
        let mut slips = vec![zero; self.layout().frictions.len()];
        self.setup.context.system().slips(&self.state, &mut slips);
        slips
    }

    /// Events of the contacts with friction that stay closed and slip otherwise than before.
    pub(super) fn record_slips(&mut self, before: ContactSet) {
        let changed = |from: fn(Slip) -> bool, to: fn(Slip) -> bool| -> ContactSet {
            let contacts = self.layout().frictions.iter().map(|friction| friction.contact);
            let stays = contacts.filter(|&i| before.contains(i) && self.closed.contains(i));
            let changed = stays.filter(|&i| before.slip(i) != self.closed.slip(i));
            changed.filter(|&i| from(before.slip(i)) && to(self.closed.slip(i))).collect()
        };
        let (sticks, slides): (fn(Slip) -> bool, fn(Slip) -> bool) =
            (|slip| slip == Slip::Stick, |slip| slip != Slip::Stick);
        let events = [
            (EventKind::Slip, changed(sticks, slides)),
            (EventKind::Stick, changed(slides, sticks)),
            (EventKind::Reverse, changed(slides, slides)),
        ];
        for (kind, set) in events {
            if !set.is_empty() {
                let note = Note::Friction(self.friction_states(set));
                self.record(kind, set, Some(note));
            }
        }
    }

    /// The forces of contacts with friction after a decision.
    fn friction_states(&self, set: ContactSet) -> Vec<FrictionState> {
        let (layout, slips) = (self.layout(), self.slip_states());
        let frictions = layout.frictions.iter().enumerate().filter(|(_, f)| set.contains(f.contact));
        let states = frictions.map(|(k, friction)| FrictionState {
            contact: layout.contacts[friction.contact].label,
            normal: self.reactions[friction.contact],
            force: self.reactions[layout.contacts.len() + k],
            limit: match self.closed.slip(friction.contact) {
                Slip::Stick => slips[k].limit,
                Slip::Forward | Slip::Backward => slips[k].kinetic,
            },
        });
        states.collect()
    }
}

/// What a motion has that is taken of several.
pub(super) fn why(reason: Reason) -> &'static str {
    match reason {
        Reason::Only => "that is left",
        Reason::Stable => "that stiff springs at the contacts would hold, the others fly apart",
        Reason::LiftOff => "with the fewest closed contacts of those that stiff springs would hold",
        Reason::Sticks => "with the most contacts that stick of those with the fewest closed",
        Reason::First => "that comes first: contacts in their order, sticking before sliding before open",
        Reason::Unstable => "with the fewest closed contacts; stiff springs would hold none",
    }
}
