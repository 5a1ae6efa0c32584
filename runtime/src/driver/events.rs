//! What a run does at each event, and what it records.

use super::{Driver, Next};
use crate::error::RunCause;
use crate::event::{Event, EventKind, reactions, supports};
use crate::model::{BarSystem, ContactSet};
use crate::moment::seen;
use crate::output::Condition;
use crate::trajectory::LogEntry;
use crate::watch::Guard;

impl<M: BarSystem> Driver<M> {
    pub(super) fn reach_horizon(&mut self) -> Result<Next, RunCause> {
        let stop = self.stops().any(|at| at == self.t);
        self.release()?;
        if stop {
            let met = |c: &&Condition| c.time(&self.setup.scene.parameters) == Some(self.t);
            let note = self.setup.conditions.iter().find(met).map(ToString::to_string);
            self.record(EventKind::Stop, ContactSet::EMPTY, note);
        } else if self.t >= self.setup.limit {
            self.record(EventKind::End, ContactSet::EMPTY, None);
        } else {
            return Ok(Next::Continue);
        }
        Ok(Next::Finished)
    }

    /// Takes away the supports whose time has come.
    pub(super) fn release(&mut self) -> Result<(), RunCause> {
        let due = self.setup.releases.iter().filter(|r| r.at <= self.t && !self.removed.contains(r.contact));
        let due = due.fold(ContactSet::EMPTY, |set, r| set.with(r.contact));
        if due.is_empty() {
            return Ok(());
        }
        self.removed = ContactSet(self.removed.0 | due.0);
        self.touching = ContactSet(self.closed.0 & !due.0);
        let before = self.touching;
        self.decide(ContactSet::EMPTY)?;
        self.record(EventKind::Release, due, None);
        let opened = ContactSet(before.0 & !self.closed.0);
        if !opened.is_empty() {
            self.record(EventKind::Open, opened, None);
        }
        Ok(())
    }

    pub(super) fn handle(&mut self, guards: &[Guard]) -> Result<Next, RunCause> {
        let pick = |kind: fn(&Guard) -> Option<usize>| {
            guards.iter().filter_map(kind).fold(ContactSet::EMPTY, ContactSet::with)
        };
        let unloaded = pick(|g| if let Guard::Reaction(i) = g { Some(*i) } else { None });
        let closing = pick(|g| if let Guard::Gap(i) = g { Some(*i) } else { None });
        let sliding = pick(|g| if let Guard::Foot { contact, .. } = g { Some(*contact) } else { None });
        let stop = guards.iter().find_map(|g| if let Guard::Stop(k) = g { Some(*k) } else { None });
        if !unloaded.is_empty() {
            self.open(unloaded)?;
        }
        if !closing.is_empty() {
            self.record(EventKind::Close, closing, None);
        }
        if !sliding.is_empty() {
            self.record(EventKind::SlideOff, sliding, None);
        }
        if let Some(k) = stop {
            let note = self.setup.conditions[k].to_string();
            self.record(EventKind::Stop, ContactSet::EMPTY, Some(note));
        }
        let ended = stop.is_some() || !closing.is_empty() || !sliding.is_empty();
        Ok(if ended { Next::Finished } else { Next::Continue })
    }

    fn open(&mut self, unloaded: ContactSet) -> Result<(), RunCause> {
        let before = self.closed;
        self.decide(unloaded)?;
        let opened = ContactSet(before.0 & !self.closed.0);
        if opened.is_empty() {
            self.record(EventKind::Touch, unloaded, None);
        } else {
            self.record(EventKind::Open, opened, None);
        }
        Ok(())
    }

    pub(super) fn record(&mut self, kind: EventKind, set: ContactSet, note: Option<String>) {
        self.trajectory.events.push(Event {
            t: self.t,
            kind,
            supports: supports::<M>(set),
            state: seen::<M>(&self.state).to_vec(),
            reactions: reactions::<M>(&self.reactions),
            note,
            coordinates: M::LAYOUT.coordinates,
        });
    }

    pub(super) fn record_touch(&mut self, t: f64, guard: Guard, (state, bearing): (Vec<f64>, Vec<f64>)) {
        let (contact, note) = match guard {
            Guard::Reaction(i) => (i, None),
            Guard::Gap(i) => (i, Some("the gap touches zero".to_owned())),
            Guard::Foot { .. } | Guard::Stop(_) => return,
        };
        self.trajectory.events.push(Event {
            t,
            kind: EventKind::Touch,
            supports: supports::<M>(ContactSet::EMPTY.with(contact)),
            state,
            reactions: reactions::<M>(&bearing),
            note,
            coordinates: M::LAYOUT.coordinates,
        });
    }

    pub(super) fn log(&mut self, text: String) {
        self.trajectory.log.push(LogEntry { t: self.t, text });
    }
}
