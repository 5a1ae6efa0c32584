//! What the judge follows of a record, and what of it is compared.

use super::Comparison;
use crate::condition::Condition;
use crate::motion::{Action, Change, Motion, Task, follow};
use crate::record::RecordedEvent;

impl Comparison<'_> {
    /// The judge's motion from a time on.
    pub(super) fn followed(&self, (t, state): (f64, &[f64]), samples: &[f64], task: Task) -> Motion {
        let record = self.record;
        let actions = self.done_from(t);
        let removed = |name: &String| {
            actions.iter().any(|(at, action)| match action {
                Action::Remove(names) => *at <= t && t > record.t && names.contains(name),
                Action::Impulse { .. } => false,
            })
        };
        let held: Vec<String> = record.held.iter().filter(|name| !removed(name)).cloned().collect();
        let awaited = record.conditions.iter().filter(|(_, met)| met.is_none_or(|met| met > t));
        let conditions: Vec<Condition> = awaited.map(|(condition, _)| condition.clone()).collect();
        let motion = follow(
            self.scene,
            &Task {
                t,
                state,
                until: self.horizon(),
                held: &held,
                actions: &actions,
                conditions: &conditions,
                ends_at_impacts: record.ends_at_impacts,
                samples,
                most_work: self.left.get(),
                kept: task.kept,
                terms: task.terms,
            },
        );
        self.left.set(self.left.get().saturating_sub(motion.work));
        motion
    }

    /// What was done at given times from a time on; what was taken away before is taken away again,
    /// what struck then has struck. What was waited for is left to be found.
    fn done_from(&self, t: f64) -> Vec<(f64, Action)> {
        let record = self.record;
        let to_find = |at: f64, action: &Action| {
            record
                .conditions
                .iter()
                .any(|(condition, met)| *met == Some(at) && condition.action.as_ref() == Some(action))
        };
        let again = record.actions.iter().filter(|(at, action)| {
            (*at > t && !to_find(*at, action))
                || *at == record.t && t == record.t
                || *at <= t && matches!(action, Action::Remove(_))
        });
        again.cloned().collect()
    }

    /// The end; beyond it where the judge has to find that.
    fn horizon(&self) -> f64 {
        let record = self.record;
        let slack = 2.0 * record.within * record.end.abs().max(record.time);
        if record.ends_by_itself() { record.end + slack } else { record.end }
    }

    /// States between events; not of the flights that the end of infinitely many impacts sums up.
    pub(super) fn samples(&self) -> impl Iterator<Item = &(f64, Vec<f64>)> {
        let summed = self.summed();
        let inside = self.record.segments.iter().flat_map(|stretch| {
            let last = stretch.samples.len().saturating_sub(1);
            stretch.samples.get(1..last).unwrap_or_default()
        });
        inside.filter(move |(t, _)| !summed.iter().any(|[from, to]| from < t && t < to))
    }

    /// From the last impact that the record has before the end of infinitely many to that end.
    fn summed(&self) -> Vec<[f64; 2]> {
        let events = &self.record.events;
        let settles = events.iter().enumerate().filter(|(_, event)| event.change == Change::Settle);
        let span = |(k, settle): (usize, &RecordedEvent)| {
            let of = |event: &&RecordedEvent| {
                event.change == Change::Impact
                    && event.contacts.iter().any(|name| settle.contacts.contains(name))
            };
            [events[..k].iter().rev().find(of).map_or(self.record.t, |event| event.t), settle.t]
        };
        settles.map(span).collect()
    }
}
