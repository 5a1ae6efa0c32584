//! Contacts with friction: what is known of their slips before a decision.

use super::DecisionInput;
use crate::contact::friction::{Reason, SharedFrictionMargin, SlipDirection, SlipVelocity as KnownSlip};
use crate::model::{ContactSet, Slip};
use crate::simulation::snapshot::Snapshot;

/// What has been located of contacts with friction at an event.
#[derive(Debug, Clone, Default)]
pub(crate) struct LocatedSlips {
    /// Contacts that stuck and have reached their limits.
    leaving: Vec<(usize, SlipDirection)>,
    /// Contacts that slid and have stopped.
    stopped: Vec<usize>,
}

impl LocatedSlips {
    /// A contact that stuck has reached its limit, unless it has stopped just now.
    pub(in crate::simulation) fn leave(&mut self, contact: usize, sense: SlipDirection) {
        if !self.stopped.contains(&contact) {
            self.leaving.push((contact, sense));
        }
    }

    /// A contact that slid has stopped, or may do anything.
    pub(in crate::simulation) fn stop(&mut self, contact: usize) {
        self.leaving.retain(|(leaving, _)| *leaving != contact);
        self.stopped.push(contact);
    }

    pub(in crate::simulation) fn is_empty(&self) -> bool {
        self.leaving.is_empty() && self.stopped.is_empty()
    }

    /// Whether contacts that stuck have reached their limits.
    pub(in crate::simulation) fn is_leaving(&self) -> bool {
        !self.leaving.is_empty()
    }

    /// The same with those contacts at rest, free to do anything.
    pub(in crate::simulation) fn at_rest(&self) -> Self {
        let leaving = self.leaving.iter().map(|(contact, _)| *contact);
        Self { leaving: Vec::new(), stopped: leaving.chain(self.stopped.iter().copied()).collect() }
    }

    /// The contacts.
    pub(in crate::simulation) fn contacts(&self) -> ContactSet {
        self.leaving.iter().map(|(contact, _)| *contact).chain(self.stopped.iter().copied()).collect()
    }
}

impl Snapshot<'_> {
    /// Contacts at rest whose force of sticking is at its limit, as at a start: they can stick now,
    /// and not in the motion that follows.
    pub(in crate::simulation) fn at_static_limits(&self, touching: ContactSet) -> LocatedSlips {
        let (set, layout, slips) = (self.slipping_as_now(touching), self.layout(), self.slip_states());
        let (reactions, bound) = self.reactions_at(&self.state, set);
        let mut located = LocatedSlips::default();
        let sticking = layout.frictions.iter().enumerate();
        for (entry, friction) in sticking.filter(|(_, friction)| {
            set.contains(friction.contact) && set.slip(friction.contact) == Slip::Stick
        }) {
            let force = reactions[layout.contacts.len() + entry];
            let limit = slips[entry].limit * reactions[friction.contact].abs();
            if (force.abs() - limit).abs() <= bound {
                let sense = if force < 0.0 { SlipDirection::Forward } else { SlipDirection::Backward };
                located.leaving.push((friction.contact, sense));
            }
        }
        located
    }

    /// At the friction limit with nonzero friction; they slip rather than open.
    pub(in crate::simulation) fn at_limit_with_load(&self, located: &LocatedSlips) -> ContactSet {
        if located.leaving.is_empty() {
            return ContactSet::EMPTY;
        }
        let (reactions, bound) = self.reactions_at(&self.state, self.active_basis());
        let (contacts, layout) = (self.layout().contacts.len(), self.layout());
        let rubs = |contact: &usize| {
            layout.contacts[*contact].friction.is_some_and(|entry| reactions[contacts + entry].abs() > bound)
        };
        located.leaving.iter().map(|(contact, _)| *contact).filter(rubs).collect()
    }

    /// How far the contacts that share their load are from slipping, however they share it.
    pub(in crate::simulation) fn shared_margin(&self) -> SharedFrictionMargin {
        let Some(rough) = self.setup.parts.laws.rough else { return SharedFrictionMargin::default() };
        let (mut reactions, bound) = self.reactions_at(&self.state, self.active_basis());
        reactions.iter_mut().filter(|load| load.abs() <= bound).for_each(|load| *load = 0.0);
        (rough.margin)(self.setup.context.system(), &self.state, &self.closed(), &reactions)
    }

    /// What is known of the slip of each touching contact with friction: what was located, how it
    /// slipped in the phase before, else what its velocity says.
    pub(in crate::simulation) fn known_slips(&self, question: &DecisionInput) -> Vec<(usize, KnownSlip)> {
        let layout = self.layout();
        if layout.frictions.is_empty() {
            return Vec::new();
        }
        let (slips, bounds) = (self.slip_states(), self.natural_slips());
        let DecisionInput { touching: set, slip_known: sensed, located, .. } = question;
        let touching = layout.frictions.iter().enumerate();
        let touching = touching.filter(|(_, friction)| set.contains(friction.contact));
        let known = touching.map(|(k, friction)| {
            let contact = friction.contact;
            let leaves = located.leaving.iter().find(|(leaving, _)| *leaving == contact);
            let stops = located.stopped.contains(&contact);
            let (velocity, bound) = (slips[k].velocity, self.bound_with(*set) * bounds[k]);
            let known = match leaves {
                Some((_, sense)) => KnownSlip::Leaves(*sense),
                None if stops => KnownSlip::Rest,
                None if layout.contacts[contact].is_hinge() && velocity.abs() <= bound => KnownSlip::Rest,
                None if sensed.contains(contact) => match set.slip(contact) {
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
}

/// What a motion has that is taken of several.
pub(super) fn reason_name(reason: Reason) -> &'static str {
    match reason {
        Reason::Only => "that is left",
        Reason::Stable => "that is stable with stiff springs at the contacts, the others are not",
        Reason::LiftOff => "with the fewest closed contacts of those that are stable with stiff springs",
        Reason::Sticks => "with the most contacts that stick of those with the fewest closed",
        Reason::First => "that comes first: contacts in their order, sticking before sliding before open",
        Reason::Unstable => "with the fewest closed contacts; none is stable with stiff springs",
    }
}
