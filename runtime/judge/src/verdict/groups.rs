//! Events that are one for all that a start in doubles tells of them.

use super::{Comparison, TOGETHER};
use crate::motion::{Change, Event, Motion};
use crate::record::RecordedEvent;
use liftoff_core::scalar::{DoubleDouble, Scalar};

/// Events of one instant.
#[derive(Clone, Debug)]
pub(super) struct Group {
    pub(super) t: f64,
    pub(super) changes: Vec<Change>,
    pub(super) contacts: Vec<String>,
    pub(super) state: Vec<f64>,
}

impl Comparison<'_> {
    pub(super) fn recorded(&self) -> Vec<Group> {
        let one = |event: &RecordedEvent| Group {
            t: event.t,
            changes: vec![event.change],
            contacts: event.contacts.clone(),
            state: event.state.clone(),
        };
        self.grouped(self.record.events.iter().map(one))
    }

    /// The judge's own events; without impacts that the record sums up in the end of infinitely
    /// many.
    pub(super) fn judged(&self, from: f64, groups: &[Group], motion: &Motion) -> Vec<Group> {
        let near = TOGETHER * self.record.time;
        let one = |event: &Event| Group {
            t: event.t.to_f64(),
            changes: vec![event.change],
            contacts: event.contacts.iter().map(|&i| self.scene.contacts[i].name.clone()).collect(),
            state: doubles(&event.state),
        };
        let mut all = self.grouped(motion.events.iter().map(one));
        for (k, group) in groups.iter().enumerate().filter(|(_, g)| g.changes.contains(&Change::Settle)) {
            let of = |g: &Group| g.contacts.iter().any(|name| group.contacts.contains(name));
            let last = groups[..k].iter().rev().find(|g| g.changes.contains(&Change::Impact) && of(g));
            let since = last.map_or(from, |g| g.t) + near;
            let until = group.t - near;
            all.retain(|g| !(g.changes == [Change::Impact] && of(g) && since < g.t && g.t < until));
        }
        // What a start in doubles decides a little later has been decided by it.
        all.retain(|g| self.record.t == from || g.t > from + near);
        all.retain(|g| !self.is_undecided(g, groups));
        all
    }

    /// Whether the record says that it does not tell whether these contacts open then, and nothing
    /// else of them: the states are compared all the same.
    fn is_undecided(&self, group: &Group, recorded: &[Group]) -> bool {
        let window = self.record.time * self.record.within.sqrt();
        let near = |t: f64| (t - group.t).abs() < window;
        let of = |names: &[String]| group.contacts.iter().any(|name| names.contains(name));
        let flies = group.changes.iter().all(|change| matches!(change, Change::Open | Change::Impact));
        let told = recorded.iter().any(|other| near(other.t) && of(&other.contacts));
        flies && !told && self.record.undecided.iter().any(|(t, names)| near(*t) && of(names))
    }

    fn grouped(&self, events: impl Iterator<Item = Group>) -> Vec<Group> {
        let near = TOGETHER * self.record.time;
        let mut all: Vec<Group> = Vec::new();
        for event in events {
            match all.last_mut().filter(|last| event.t - last.t <= near) {
                Some(last) => {
                    last.changes.extend(event.changes);
                    last.contacts.extend(event.contacts);
                    last.state = event.state;
                }
                None => all.push(event),
            }
        }
        for group in &mut all {
            group.contacts.sort();
            group.contacts.dedup();
            group.changes.dedup();
        }
        all
    }
}

pub(super) fn doubles(state: &[DoubleDouble]) -> Vec<f64> {
    state.iter().map(|x| x.to_f64()).collect()
}

pub(super) fn described(group: &Group) -> String {
    let names: Vec<String> =
        group.changes.iter().map(|change| format!("{change:?}").to_lowercase()).collect();
    format!("{} of {} at t = {}", names.join(" and "), group.contacts.join(", "), group.t)
}
