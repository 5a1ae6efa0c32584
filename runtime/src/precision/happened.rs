//! The events of a run, to be found again in another; what only touches zero does not count.

use crate::event::EventKind;
use crate::model::BarSystem;
use crate::trajectory::Trajectory;

/// An event.
pub(super) struct Happened {
    /// Its place among all events of its run.
    pub(super) index: usize,
    pub(super) t: f64,
    kind: EventKind,
    supports: Vec<&'static str>,
}

impl Happened {
    pub(super) fn all<M: BarSystem>(run: &Trajectory<M>) -> Vec<Self> {
        let events = run.events().iter().enumerate().filter(|(_, event)| event.kind != EventKind::Touch);
        let happened = |(index, event): (usize, &crate::Event)| Self {
            index,
            t: event.t,
            kind: event.kind,
            supports: event.supports.clone(),
        };
        events.map(happened).collect()
    }

    pub(super) fn is(&self, other: &Self) -> bool {
        (self.kind, &self.supports) == (other.kind, &other.supports)
    }

    /// In a line.
    pub(super) fn told(events: &[Self]) -> String {
        let one = |event: &Self| match event.supports.len() {
            0 => event.kind.to_string(),
            _ => format!("{} {}", event.supports.join(" "), event.kind),
        };
        events.iter().map(one).collect::<Vec<_>>().join(", ")
    }
}
