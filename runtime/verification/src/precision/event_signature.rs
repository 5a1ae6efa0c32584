//! The events of a run, to be found again in another; what only touches zero does not count.

use liftoff::Trajectory;
use liftoff::event::EventKind;

/// What tells an event from others.
pub(super) struct EventSignature {
    /// Its place among all events of its run.
    pub(super) index: usize,
    pub(super) t: f64,
    kind: EventKind,
    supports: Vec<&'static str>,
}

impl EventSignature {
    pub(super) fn all(run: &Trajectory) -> Vec<Self> {
        let events = run.events().iter().enumerate().filter(|(_, event)| event.kind != EventKind::Touch);
        let signature = |(index, event): (usize, &liftoff::Event)| Self {
            index,
            t: event.t,
            kind: event.kind,
            supports: event.supports.clone(),
        };
        events.map(signature).collect()
    }

    pub(super) fn is(&self, other: &Self) -> bool {
        (self.kind, &self.supports) == (other.kind, &other.supports)
    }

    /// In a line.
    pub(super) fn describe(events: &[Self]) -> String {
        let one = |event: &Self| match event.supports.len() {
            0 => event.kind.to_string(),
            _ => format!("{} {}", event.supports.join(" "), event.kind),
        };
        events.iter().map(one).collect::<Vec<_>>().join(", ")
    }
}
