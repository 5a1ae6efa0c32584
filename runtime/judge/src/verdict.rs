//! A finished motion against the judge's own: event by event, state by state. Where they part slowly, as neighbours of a
//! sensitive motion do, the judge begins again from the last event that agrees.

use std::time::{Duration, Instant};

use crate::audit::audit;
use crate::motion::{Action, Change, Event, Motion, Task, follow};
use crate::record::{Happening, Record, Verdict};
use crate::scene::Scene;
use liftoff_core::scalar::{DoubleDouble, Scalar};

/// The judge begins again so many times at most.
const AGAIN: usize = 12;
/// Events nearer than this, in natural times, are one.
const TOGETHER: f64 = 1e-7;

/// Events of one instant.
#[derive(Clone, Debug)]
struct Group {
    t: f64,
    changes: Vec<Change>,
    contacts: Vec<String>,
    state: Vec<f64>,
}

pub(crate) fn verdict(scene: &Scene<DoubleDouble>, record: &Record, patience: Duration) -> Verdict {
    let audited = audit(scene, record);
    if !matches!(audited, Verdict::Agrees { .. }) {
        return audited;
    }
    let comparison = Comparison { scene, record, deadline: Instant::now() + patience };
    comparison.verdict()
}

struct Comparison<'a> {
    scene: &'a Scene<DoubleDouble>,
    record: &'a Record,
    deadline: Instant,
}

/// Where and how a motion parts from the judge's.
struct Parting {
    /// The groups that agreed.
    agreed: usize,
    t: f64,
    what: String,
}

impl Comparison<'_> {
    fn verdict(&self) -> Verdict {
        let groups = self.recorded();
        let (mut from, mut error) = (0, 0.0_f64);
        for _ in 0..AGAIN {
            let (t, state) = match from {
                0 => (self.record.t, &self.record.start),
                k => (groups[k - 1].t, &groups[k - 1].state),
            };
            let motion = self.followed(t, state);
            let why = motion.stopped.as_ref().map(ToString::to_string);
            match self.compared((t, &groups[from..]), &motion, &mut error) {
                Ok(()) => match why {
                    Some(why) => return Verdict::NotJudged { why },
                    None => return Verdict::Agrees { error },
                },
                Err(Parting { agreed: 0, t, what }) => {
                    return match why {
                        Some(why) if motion.events.is_empty() => Verdict::NotJudged { why },
                        _ => Verdict::Disagrees { t, what },
                    };
                }
                Err(Parting { agreed, .. }) => from += agreed,
            }
        }
        Verdict::NotJudged { why: "the motion parts from its neighbours again and again".to_owned() }
    }

    fn followed(&self, t: f64, state: &[f64]) -> Motion {
        let record = self.record;
        let samples: Vec<f64> = self.samples().map(|(t, _)| *t).filter(|&at| at > t).collect();
        let actions: Vec<(f64, Action)> = record.actions.clone();
        // What was taken away before is taken away again; what struck then has struck.
        let again = actions.into_iter().filter(|(at, action)| {
            *at > t || *at == record.t && t == record.t || matches!(action, Action::Remove(_))
        });
        let actions: Vec<(f64, Action)> = again.collect();
        let removed = |name: &String| {
            actions.iter().any(|(at, action)| match action {
                Action::Remove(names) => *at <= t && t > record.t && names.contains(name),
                Action::Impulse { .. } => false,
            })
        };
        let held: Vec<String> = record.held.iter().filter(|name| !removed(name)).cloned().collect();
        let closes = record.events.last().is_some_and(|event| event.state.is_empty());
        let until = if closes { record.end + 1e-6 * record.time } else { record.end };
        let patience = self.deadline.saturating_duration_since(Instant::now());
        let task = Task { t, state, until, held: &held, actions: &actions, samples: &samples, patience };
        follow(self.scene, &task)
    }

    /// States between events; not of the flights that the end of infinitely many impacts sums up.
    fn samples(&self) -> impl Iterator<Item = &(f64, Vec<f64>)> {
        let summed = self.summed();
        let inside = self.record.stretches.iter().flat_map(|stretch| {
            let last = stretch.samples.len().saturating_sub(1);
            stretch.samples.get(1..last).unwrap_or_default()
        });
        inside.filter(move |(t, _)| !summed.iter().any(|[from, to]| from < t && t < to))
    }

    /// From the last impact that the record has before the end of infinitely many to that end.
    fn summed(&self) -> Vec<[f64; 2]> {
        let events = &self.record.events;
        let settles = events.iter().enumerate().filter(|(_, event)| event.change == Change::Settle);
        let span = |(k, settle): (usize, &Happening)| {
            let of = |event: &&Happening| {
                event.change == Change::Impact
                    && event.contacts.iter().any(|name| settle.contacts.contains(name))
            };
            [events[..k].iter().rev().find(of).map_or(self.record.t, |event| event.t), settle.t]
        };
        settles.map(span).collect()
    }

    /// Compares from a time on; how far they are apart is taken in as long as they agree.
    fn compared(
        &self,
        (from, groups): (f64, &[Group]),
        motion: &Motion,
        error: &mut f64,
    ) -> Result<(), Parting> {
        let record = self.record;
        let near = TOGETHER * record.time;
        let judged = self.judged(from, groups, motion);
        let stopped = motion.stopped.is_some();
        let reached = |t: f64| !stopped || motion.samples.last().is_some_and(|(last, _)| t <= *last);
        let (mut agreed, mut samples) = (0, motion.samples.iter().peekable());
        let mut recorded = self.samples().filter(|(t, _)| *t > from).peekable();
        for k in 0..=groups.len().max(judged.len()) {
            let (own, other) = (judged.get(k), groups.get(k));
            let until = own.map_or(f64::INFINITY, |g| g.t).min(other.map_or(f64::INFINITY, |g| g.t)) - near;
            while let Some((t, state)) = samples.next_if(|(t, _)| *t < until) {
                let Some((_, there)) = recorded.next_if(|(at, _)| at == t) else { continue };
                let apart = record.apart(&doubles(state), there);
                if apart > record.within {
                    let what = format!("the states are {apart:.1e} apart");
                    return Err(Parting { agreed, t: *t, what });
                }
                *error = error.max(apart);
            }
            let late = |g: &Group| g.t > record.end - near;
            let parted = |t: f64, what: String| Err(Parting { agreed, t, what });
            match (own, other) {
                (None, None) => return Ok(()),
                (None, Some(other)) if late(other) || !reached(other.t) => return Ok(()),
                (Some(own), None) if late(own) => return Ok(()),
                (None, Some(other)) => return parted(other.t, format!("{} is not found", described(other))),
                (Some(own), None) => return parted(own.t, format!("{} is missed", described(own))),
                (Some(own), Some(other)) => {
                    let late = record.late(own.t, other.t);
                    if late > record.within.max(TOGETHER) {
                        let (own, other) = (described(own), described(other));
                        return parted(
                            other_time(judged.get(k), groups.get(k)),
                            format!("{own}, not {other}"),
                        );
                    }
                    let apart =
                        if other.state.is_empty() { 0.0 } else { record.apart(&own.state, &other.state) };
                    let (a, b) = (own.changes.contains(&Change::Open), other.changes.contains(&Change::Open));
                    if apart > record.within || (a && b && own.contacts != other.contacts) {
                        let text = format!("{}, not {}: {apart:.1e} apart", described(own), described(other));
                        return parted(other.t, text);
                    }
                    *error = error.max(apart).max(late);
                    agreed = k + 1;
                }
            }
        }
        Ok(())
    }

    fn recorded(&self) -> Vec<Group> {
        let one = |event: &Happening| Group {
            t: event.t,
            changes: vec![event.change],
            contacts: event.contacts.clone(),
            state: event.state.clone(),
        };
        self.grouped(self.record.events.iter().map(one))
    }

    /// The judge's own events; without impacts that the record sums up in the end of infinitely many.
    fn judged(&self, from: f64, groups: &[Group], motion: &Motion) -> Vec<Group> {
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
        all
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

fn other_time(own: Option<&Group>, other: Option<&Group>) -> f64 {
    own.into_iter().chain(other).map(|g| g.t).fold(f64::INFINITY, f64::min)
}

fn doubles(state: &[DoubleDouble]) -> Vec<f64> {
    state.iter().map(|x| x.to_f64()).collect()
}

fn described(group: &Group) -> String {
    let names: Vec<String> =
        group.changes.iter().map(|change| format!("{change:?}").to_lowercase()).collect();
    format!("{} of {} at t = {}", names.join(" and "), group.contacts.join(", "), group.t)
}
