//! A reference by the independent judge: its own motion, its own events, twice with series of
//! different order. Of the run it has the start, what is done and waited for, and the names that
//! its events go by.

use liftoff::{Event, EventKind};
use liftoff::{Scales, Trajectory};
use liftoff_core::scalar::{DoubleDouble, Real, Scalar};
use liftoff_core::system::System;
use liftoff_judge::{Change, Motion, Task};
use liftoff_replay::ReplayError;

use super::samples;
use super::{Computed, Reference, ReferenceError, ReferenceEvent, Source};
use crate::judgement::{Testimony, change_of};
use std::sync::Arc;

/// Terms of the series the second time.
const FEWER: usize = Task::TERMS - 5;
/// An event of the run and one of the judge's further apart than this, relative or in natural
/// times, are two.
const NEAR: f64 = 1e-6;

pub(super) fn judged(
    run: &Trajectory,
    held: &[&str],
    system: &Arc<dyn System<DoubleDouble>>,
) -> Result<Reference, ReferenceError> {
    let not_judged = |why: String| ReferenceError::NotJudged { why };
    let testimony = Testimony::from_run(run, held).ok_or(ReplayError::Empty)?;
    if let Some(given) = testimony.given() {
        return Err(not_judged(given.to_owned()));
    }
    let kept = kept(run, system);
    let samples = samples(run);
    let one = |terms: usize| -> Result<Computed, ReferenceError> {
        let task = Task { kept: &kept, terms, samples: &samples, ..Task::default() };
        let (motion, contacts) = testimony.followed(task).map_err(not_judged)?;
        let events = Pairing::new(run, &motion, &contacts).events()?;
        Ok(Computed { events, samples: motion.samples, end: motion.end })
    };
    let (fine, coarse) = (one(Task::TERMS)?, one(FEWER)?);
    Reference::of_two(run, Source::Judge, fine, coarse)
}

/// The entries of the state that the first phase integrates.
fn kept(run: &Trajectory, system: &Arc<dyn System<DoubleDouble>>) -> Vec<usize> {
    let entries = 2 * run.layout().coordinates.len();
    let segments = run.segments();
    let Some(first) = segments.first() else { return Vec::new() };
    let phase = Arc::clone(system).phase(first.active_basis, first.form);
    phase.kept().iter().copied().filter(|&entry| entry < entries).collect()
}

/// A run's events and the judge's.
struct Pairing<'a> {
    run: &'a Trajectory,
    motion: &'a Motion,
    contacts: &'a [String],
    claimed: Vec<bool>,
}

impl<'a> Pairing<'a> {
    fn new(run: &'a Trajectory, motion: &'a Motion, contacts: &'a [String]) -> Self {
        Self { run, motion, contacts, claimed: vec![false; motion.events.len()] }
    }

    fn events(mut self) -> Result<Vec<ReferenceEvent>, ReferenceError> {
        let mut all: Vec<ReferenceEvent> = Vec::new();
        for event in self.run.events() {
            let t = self.time(event, all.last().and_then(|last| last.t))?;
            all.push(ReferenceEvent { kind: event.kind, supports: event.supports.clone(), t, summed: false });
        }
        self.sum_up(&mut all)?;
        Ok(all)
    }

    /// When the judge finds it; none of touches.
    fn time(
        &mut self,
        event: &Event,
        last: Option<DoubleDouble>,
    ) -> Result<Option<DoubleDouble>, ReferenceError> {
        let change = match event.kind {
            EventKind::Touch => return Ok(None),
            EventKind::Start | EventKind::End => return Ok(Some(DoubleDouble::from_f64(event.t))),
            _ => change_of(self.run, event),
        };
        let Some(change) = change else {
            // It ends at a given time, or with the event before.
            let given = DoubleDouble::from_f64(event.t);
            return Ok(Some(last.filter(|last| last.to_f64() == event.t).unwrap_or(given)));
        };
        let own = (0..self.claimed.len()).filter(|&i| self.is_near(i, event.t));
        let own: Vec<usize> = own.collect();
        let same = own.iter().copied().find(|&i| {
            let found = &self.motion.events[i];
            !self.claimed[i] && found.change == change && self.shares(i, event)
        });
        let found = same.or_else(|| own.first().copied()).ok_or(ReplayError::Event { t: event.t })?;
        self.claimed[found] |= same.is_some();
        Ok(Some(self.motion.events[found].t))
    }

    fn is_near(&self, i: usize, t: f64) -> bool {
        let Scales { time, .. } = self.run.scales();
        (self.motion.events[i].t.to_f64() - t).abs() <= NEAR * t.abs().max(time)
    }

    fn shares(&self, i: usize, event: &Event) -> bool {
        let found = &self.motion.events[i].contacts;
        found.is_empty() || found.iter().any(|&i| event.supports.iter().any(|name| self.contacts[i] == *name))
    }

    /// Of infinitely many impacts runs sum up more or less: the judge's are put in, and those that
    /// need not be are marked.
    fn sum_up(&self, all: &mut Vec<ReferenceEvent>) -> Result<(), ReferenceError> {
        let settles: Vec<Event> =
            self.run.events().iter().filter(|event| event.kind == EventKind::Settle).cloned().collect();
        for settle in &settles {
            mark(all, settle);
        }
        for (i, found) in self.motion.events.iter().enumerate() {
            let t = found.t.to_f64();
            if self.claimed[i] || t > self.run.end_time() {
                continue;
            }
            let settle = settles.iter().find(|settle| settle.t > t && self.shares(i, settle));
            let kind = settle.and_then(|settle| summed(all, settle));
            let (kind, supports) = match kind {
                Some(kind) if found.change == Change::Impact => kind,
                _ if self.run.events().iter().any(|event| self.is_near(i, event.t)) => continue,
                _ => return Err(ReferenceError::Missed { t }),
            };
            let place = all.iter().position(|event| event.t.is_some_and(|at| at > found.t));
            let summed = ReferenceEvent { kind, supports, t: Some(found.t), summed: true };
            all.insert(place.unwrap_or(all.len()), summed);
        }
        Ok(())
    }
}

/// What the impacts are that an end of infinitely many sums up.
fn summed(all: &[ReferenceEvent], settle: &Event) -> Option<(EventKind, Vec<&'static str>)> {
    let end = all.iter().position(|event| event.is(settle))?;
    let last = all[..end].iter().rev().find(|event| event.is_impact_of(settle))?;
    Some((last.kind, last.supports.clone()))
}

/// All impacts but the first of those that come to an end.
fn mark(all: &mut [ReferenceEvent], settle: &Event) {
    let Some(end) = all.iter().position(|event| event.is(settle)) else { return };
    let before = all[..end].iter().rev().take_while(|event| event.is_impact_of(settle)).count();
    all[end - before..end].iter_mut().skip(1).for_each(|event| event.summed = true);
}

impl ReferenceEvent {
    fn is(&self, event: &Event) -> bool {
        let near = self.t.is_some_and(|t| (t.to_f64() - event.t).abs() <= NEAR * event.t.abs());
        near && self.kind == event.kind && self.supports == event.supports
    }

    fn is_impact_of(&self, settle: &Event) -> bool {
        matches!(self.kind, EventKind::Impact | EventKind::Taut)
            && self.supports.iter().any(|name| settle.supports.contains(name))
    }
}
