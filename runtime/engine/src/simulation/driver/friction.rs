//! Contacts with friction: what is known of their slips before a decision, and the events that it makes.

use super::Driver;
use crate::contact::friction::{Reason, Sense, Slip as KnownSlip, margin};
use crate::contact::impulse::{Outcome, Row};
use crate::contact::{Alternatives, ContactError};
use crate::context::{Numbers, Slips, slips};
use crate::event::detection::{Guard, Rub};
use crate::event::{EventKind, FrictionState, Note};
use crate::integrate::StepError;
use crate::model::{ContactSet, Friction, Slip};
use crate::simulation::RunCause;
use crate::trajectory::LoggedDecision;

/// An energy gained by less than this part of a natural one is rounding.
const GAINED: f64 = 1e-12;

/// What has been located of contacts with friction at an event.
#[derive(Debug, Clone, Default)]
pub(super) struct LocatedSlips {
    /// Contacts that stuck and have reached their limits.
    leaving: Vec<(usize, Sense)>,
    /// Contacts that slid and have stopped.
    stopped: Vec<usize>,
}

impl LocatedSlips {
    pub(super) fn is_empty(&self) -> bool {
        self.leaving.is_empty() && self.stopped.is_empty()
    }

    /// Whether contacts that stuck have reached their limits.
    pub(super) fn is_leaving(&self) -> bool {
        !self.leaving.is_empty()
    }

    /// The same with those contacts at rest, free to do anything.
    pub(super) fn at_rest(&self) -> Self {
        let leaving = self.leaving.iter().map(|(contact, _)| *contact);
        Self { leaving: Vec::new(), stopped: leaving.chain(self.stopped.iter().copied()).collect() }
    }

    /// The contacts.
    pub(super) fn contacts(&self) -> ContactSet {
        self.leaving.iter().map(|(contact, _)| *contact).chain(self.stopped.iter().copied()).collect()
    }
}

impl Driver<'_> {
    /// What the guards of an event say of slips.
    pub(super) fn located_slips(&self, guards: &[Guard]) -> LocatedSlips {
        let mut located = LocatedSlips::default();
        for guard in guards {
            match guard {
                Guard::Limit(Rub { contact, slip: Slip::Backward, .. }) => {
                    located.leaving.push((*contact, Sense::Backward));
                }
                Guard::Limit(rub) => located.leaving.push((rub.contact, Sense::Forward)),
                Guard::Slip(rub) => located.stopped.push(rub.contact),
                // With N = 0 it may slide in either sense.
                Guard::Side(contact, _) if self.closed.slip(*contact) == Slip::Stick => {
                    located.stopped.push(*contact);
                }
                Guard::Grip => located.leaving.extend(self.leaving_together()),
                _ => {}
            }
        }
        let LocatedSlips { leaving, stopped } = &mut located;
        leaving.retain(|(contact, _)| !stopped.contains(contact));
        located
    }

    /// Contacts at rest whose force of sticking is at its limit, as at a start: they can stick now, and not in the motion that follows.
    pub(super) fn at_static_limits(&self) -> LocatedSlips {
        let (set, layout, slips) = (self.slipping_as_now(self.touching), self.layout(), self.slip_states());
        let (reactions, bound) = self.reactions_at(&self.state, set);
        let mut located = LocatedSlips::default();
        let sticking = layout.frictions.iter().enumerate();
        for (entry, friction) in sticking.filter(|(_, friction)| {
            set.contains(friction.contact) && set.slip(friction.contact) == Slip::Stick
        }) {
            let force = reactions[layout.contacts.len() + entry];
            let limit = slips[entry].limit * reactions[friction.contact].abs();
            if (force.abs() - limit).abs() <= bound {
                let sense = if force < 0.0 { Sense::Forward } else { Sense::Backward };
                located.leaving.push((friction.contact, sense));
            }
        }
        located
    }

    /// Contacts at their limits whose friction is not zero: they slip, however small N = |R|/μ may be.
    pub(super) fn still_rubbing(&self, located: &LocatedSlips) -> ContactSet {
        if located.leaving.is_empty() {
            return ContactSet::EMPTY;
        }
        let (reactions, bound) = self.reactions_at(&self.state, self.bearing);
        let (contacts, layout) = (self.layout().contacts.len(), self.layout());
        let rubs = |contact: &usize| {
            layout.contacts[*contact].friction.is_some_and(|entry| reactions[contacts + entry].abs() > bound)
        };
        located.leaving.iter().map(|(contact, _)| *contact).filter(rubs).collect()
    }

    /// The contacts that share their load and slip now, however they do.
    fn leaving_together(&self) -> Vec<(usize, Sense)> {
        let (reactions, _) = self.reactions_at(&self.state, self.bearing);
        margin(self.setup.context.system(), &self.state, &self.closed, &reactions).leaving
    }

    /// What is known of the slip of each touching contact with friction: what was located, how it slipped in the phase
    /// before, else what its velocity says.
    pub(super) fn known_slips(&self, located: &LocatedSlips) -> Vec<(usize, KnownSlip)> {
        let layout = self.layout();
        if layout.frictions.is_empty() {
            return Vec::new();
        }
        let slips = self.slip_states();
        let bounds = self.natural_slips();
        let touching = layout.frictions.iter().enumerate();
        let touching = touching.filter(|(_, friction)| self.touching.contains(friction.contact));
        let known = touching.map(|(k, friction)| {
            let contact = friction.contact;
            let leaves = located.leaving.iter().find(|(leaving, _)| *leaving == contact);
            let stops = located.stopped.contains(&contact);
            let (velocity, bound) = (slips[k].velocity, self.relative_bound() * bounds[k]);
            let known = match leaves {
                Some((_, sense)) => KnownSlip::Leaves(*sense),
                None if stops => KnownSlip::Rest,
                None if layout.contacts[contact].is_hinge() && velocity.abs() <= bound => KnownSlip::Rest,
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

    /// What of the motions that the law of friction allows was taken.
    pub(super) fn log_alternatives(&mut self, found: Option<Alternatives>) {
        let Some(Alternatives { motions, taken, reason, complete, determined }) = found else { return };
        if !complete {
            self.log(LoggedDecision::MotionsNotCounted);
        }
        if !determined {
            self.log(LoggedDecision::MotionNotDetermined);
        }
        if motions.len() > 1 {
            self.log(LoggedDecision::SeveralMotions { motions, taken, why: why(reason) });
        }
    }

    /// Motion that is not a number where hinges slide has come to where their law leaves none.
    pub(super) fn refuse_hinges(&self, error: &StepError) -> Result<(), RunCause> {
        let sliding = self.layout().sliding(&self.closed).map(|(_, friction)| friction.contact);
        let hinges =
            sliding.map(|contact| &self.layout().contacts[contact]).filter(|contact| contact.is_hinge());
        let hinges: Vec<String> = hinges.map(|contact| contact.label.to_owned()).collect();
        match (matches!(error, StepError::NotFinite { .. }), hinges.is_empty()) {
            (true, false) => Err(self.contact_error(ContactError::Hinges { hinges })),
            _ => Ok(()),
        }
    }

    /// The part of a slip's row in a collision, with its μ.
    pub(super) fn rubbing(&self, of: usize, entry: usize, mu: f64) -> Row {
        let restitution = self.setup.restitution.get(self.layout().contacts.len() + entry);
        Row::Friction { of, mu, restitution: restitution.copied().unwrap_or(0.0) }
    }

    /// The energy that a law of impact has gained by more than rounding, J.
    pub(super) fn gained(&self, outcome: &Outcome) -> Option<f64> {
        let scales = &self.setup.context.scales;
        let natural = scales.force() * scales.length;
        let rubs = self.layout().frictions.iter().any(|friction| outcome.impulses[friction.row] != 0.0);
        Some(outcome.gained).filter(|gained| rubs && *gained > GAINED * natural)
    }

    /// The natural slip velocity of each contact with friction; of a hinge that of its journal's surface at a radian in the natural
    /// time.
    pub(super) fn natural_slips(&self) -> Numbers {
        let (layout, scales) = (self.layout(), &self.setup.context.scales);
        if layout.frictions.is_empty() {
            return Numbers::new();
        }
        let equations = layout.has_hinges().then(|| self.setup.context.system().equations(&self.state));
        let unit = |friction: &Friction| {
            let hinges = equations.as_ref().filter(|_| layout.contacts[friction.contact].is_hinge());
            let Some(equations) = hinges else { return scales.speed() };
            let entries = equations.jacobian(friction.row).iter().zip(layout.coordinates);
            entries.map(|(entry, c)| (entry * scales.coordinate(c)).abs()).fold(0.0, f64::max) / scales.time
        };
        layout.frictions.iter().map(unit).collect()
    }

    pub(super) fn slip_states(&self) -> Slips {
        slips(self.setup.context.system(), &self.state)
    }

    /// Events of the contacts with friction that stay closed and slip otherwise than before, or press to the other side.
    pub(super) fn record_slips(&mut self, before: ContactSet) {
        let guides = self.guides().iter();
        let turned =
            guides.filter(|&i| before.contains(i) && before.side(i) != self.closed.side(i)).collect();
        self.record_some(EventKind::Side, turned);
        for kind in [EventKind::Slip, EventKind::Stick, EventKind::Reverse] {
            let contacts = self.layout().frictions.iter().map(|friction| friction.contact);
            let stays = contacts.filter(|&i| before.contains(i) && self.closed.contains(i));
            let set: ContactSet =
                stays.filter(|&i| change(before.slip(i), self.closed.slip(i)) == Some(kind)).collect();
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
        let states = frictions.map(|(k, friction)| {
            let [normal, force] =
                [friction.contact, layout.contacts.len() + k].map(|entry| self.reactions[entry]);
            let limit = slips[k].limit;
            let slides = self.closed.slip(friction.contact) != Slip::Stick;
            let beside = (1.0 - self.relative_bound()) * limit * normal.abs();
            let undecided = !slides && normal != 0.0 && force.abs() >= beside;
            FrictionState {
                contact: layout.contacts[friction.contact].label,
                normal,
                force,
                limit,
                slides,
                undecided,
            }
        });
        states.collect()
    }
}

/// The event of a contact that slips otherwise than before.
fn change(before: Slip, after: Slip) -> Option<EventKind> {
    match (before, after) {
        _ if before == after => None,
        (Slip::Stick, _) => Some(EventKind::Slip),
        (_, Slip::Stick) => Some(EventKind::Stick),
        _ => Some(EventKind::Reverse),
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
