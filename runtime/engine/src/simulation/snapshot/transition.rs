//! What a snapshot tells of what has happened to it: events, decisions, impulses.

use nalgebra::DVector;

use super::Snapshot;
use crate::context::CLOSED;
use crate::event::{Event, EventKind, FrictionState, Note, PreImpact, reactions, supports};
use crate::model::{ContactKind, ContactSet, Energy, Layout, Slip};
use crate::trajectory::{AppliedImpulse, LogEntry, LoggedDecision};

/// What has happened, in its order.
#[derive(Debug, Default)]
pub(crate) struct TransitionRecord {
    pub(in crate::simulation) events: Vec<Event>,
    pub(in crate::simulation) log: Vec<LogEntry>,
    pub(in crate::simulation) impulses: Vec<AppliedImpulse>,
}

impl Snapshot<'_> {
    /// Tells an event.
    pub(in crate::simulation) fn record(&mut self, kind: EventKind, set: ContactSet, note: Option<Note>) {
        let event = self.event(kind, set, note);
        self.transition.events.push(event);
    }

    /// The same unless it is of no contact.
    pub(in crate::simulation) fn record_some(&mut self, kind: EventKind, set: ContactSet) {
        if !set.is_empty() {
            self.record(kind, set, None);
        }
    }

    /// An event with the impulses of the contacts in `shown`.
    pub(in crate::simulation) fn record_impact(
        &mut self,
        kind: EventKind,
        set: ContactSet,
        shown: ContactSet,
        (before, impulses): (Option<PreImpact>, &DVector<f64>),
        note: Option<Note>,
    ) {
        let mut event = self.event(kind, set, note);
        event.impulses = reactions(self.layout(), impulses.as_slice());
        event.impulses.retain(|impulse| shown.contains(impulse.contact));
        event.before = before;
        if let Some(before) = event.before.as_mut().filter(|_| kind != EventKind::Impulse) {
            before.impulses = impulses.as_slice().to_vec();
        }
        self.transition.events.push(event);
    }

    /// An event now, without impulses.
    pub(in crate::simulation) fn event(&self, kind: EventKind, set: ContactSet, note: Option<Note>) -> Event {
        Event {
            t: self.t,
            kind,
            supports: supports(self.layout(), set),
            state: self.public_state().to_vec(),
            energy: self.energy(),
            before: None,
            reactions: reactions(self.layout(), &self.reactions),
            impulses: Vec::new(),
            note,
            coordinates: self.layout().coordinates,
            dependent: self.setup.context.dependent(&self.state),
            length: self.setup.context.scales.length,
        }
    }

    /// What of the contacts that were closed before has come open, or slips otherwise.
    pub(in crate::simulation) fn record_changes(&mut self, before: ContactSet) {
        if before == self.closed() {
            return;
        }
        self.record_opened(before.difference(self.closed()));
        self.record_slips(before);
    }

    /// Supports open, threads go slack.
    pub(in crate::simulation) fn record_opened(&mut self, opened: ContactSet) {
        let (threads, supports) = split(self.layout(), opened);
        self.record_some(EventKind::Open, supports);
        self.record_some(EventKind::Slack, threads);
    }

    /// Events of the contacts with friction that stay closed and slip otherwise than before, or
    /// press to the other side.
    pub(in crate::simulation) fn record_slips(&mut self, before: ContactSet) {
        let (guides, closed) = (self.contacts.guides().iter(), self.closed());
        let turned = guides.filter(|&i| before.contains(i) && before.side(i) != closed.side(i)).collect();
        self.record_some(EventKind::Side, turned);
        for kind in [EventKind::Slip, EventKind::Stick, EventKind::Reverse] {
            let contacts = self.layout().frictions.iter().map(|friction| friction.contact);
            let stays = contacts.filter(|&i| before.contains(i) && closed.contains(i));
            let set: ContactSet =
                stays.filter(|&i| change(before.slip(i), closed.slip(i)) == Some(kind)).collect();
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
            let slides = self.closed().slip(friction.contact) != Slip::Stick;
            let beside = (1.0 - self.relative_bound()) * limit * normal.abs();
            let undecided = !slides && normal != 0.0 && force.abs() >= beside;
            let contact = layout.contacts[friction.contact].label;
            FrictionState { contact, normal, force, limit, slides, undecided }
        });
        states.collect()
    }

    /// Events from the `first` on are undecided, unless something else is said of them.
    pub(in crate::simulation) fn mark_undecided(&mut self, first: usize) {
        let events = self.transition.events.iter_mut().skip(first);
        events.for_each(|event| _ = event.note.get_or_insert(Note::Undecided));
    }

    /// Logs how deep the start asks for contacts to be penetrated, if that is more than the
    /// rounding of a pose.
    pub(super) fn log_depth(&mut self, depth: f64) {
        if depth > CLOSED * self.setup.context.scales.length {
            self.log(LoggedDecision::StartPenetrates(depth));
        }
    }

    pub(in crate::simulation) fn log(&mut self, decision: LoggedDecision) {
        self.transition.log.push(LogEntry { t: self.t, decision });
    }

    /// What an impact finds.
    pub(in crate::simulation) fn pre_impact(&self) -> PreImpact {
        let bears = |i: &usize| self.reactions[*i] != 0.0;
        let bearing = self.closed().iter().filter(bears).collect();
        PreImpact {
            state: self.public_state().to_vec(),
            energy: self.energy(),
            active_basis: bearing,
            impulses: Vec::new(),
        }
    }

    pub(in crate::simulation) fn energy(&self) -> Energy<f64> {
        self.setup.context.system().energy(&self.state)
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

/// The threads of a set, and the others.
pub(crate) fn split(layout: &Layout, set: ContactSet) -> (ContactSet, ContactSet) {
    let is_thread = |i: &usize| layout.contacts[*i].kind == ContactKind::Thread;
    let threads = set.iter().filter(is_thread).collect();
    (threads, set.difference(threads))
}
