//! A finished motion against the judge's own: event by event, state by state. Where they part
//! slowly, as neighbours of a sensitive motion do, the judge begins again from the last event that
//! agrees.

mod follow;
mod groups;

use std::cell::Cell;

use crate::audit::audit;
use crate::motion::{Change, Motion, NotJudged, Task};
use crate::record::{Record, Verdict};
use crate::scene::Scene;
use groups::{Group, described, doubles};
use liftoff_core::scalar::DoubleDouble;

/// The judge begins again so many times at most.
const AGAIN: usize = 12;
/// How far aside a neighbour begins, in natural units.
const ASIDE: f64 = 1e-12;
/// Tolerances that the errors of a run's steps come to.
const ERRORS: f64 = 10.0;
/// At such a tolerance a run says nothing of its events.
const COARSE: f64 = 0.1;
/// Events nearer than this, in natural times, are one.
const TOGETHER: f64 = 1e-7;

pub(crate) fn verdict(scene: &Scene<DoubleDouble>, record: &Record, most_work: u64) -> Verdict {
    if let Some(reason) = beyond(record) {
        return Verdict::NotJudged { why: reason.to_string() };
    }
    let audited = audit(scene, record);
    if !matches!(audited, Verdict::Agrees { .. }) {
        return audited;
    }
    let comparison = Comparison { scene, record, left: Cell::new(most_work) };
    comparison.verdict()
}

/// The judge's motion from the start of a record.
pub(crate) fn repeated(scene: &Scene<DoubleDouble>, record: &Record, task: Task) -> Motion {
    if let Some(reason) = beyond(record) {
        return Motion { stopped: Some(reason), ..Motion::default() };
    }
    let comparison = Comparison { scene, record, left: Cell::new(task.most_work) };
    comparison.followed((record.t, &record.start), task.samples, task)
}

/// Powers of steps of such a motion are no doubles, or nothing can be expected of it.
fn beyond(record: &Record) -> Option<NotJudged> {
    let near = record.time > 1e-10 && record.time < 1e10;
    let coarse = record.tolerance >= COARSE;
    match near {
        false => Some(NotJudged::Scale(record.time)),
        true => coarse.then_some(NotJudged::Coarse(record.tolerance)),
    }
}

struct Comparison<'a> {
    scene: &'a Scene<DoubleDouble>,
    record: &'a Record,
    /// The work that is left.
    left: Cell<u64>,
}

/// Where and how a motion parts from the judge's.
struct Divergence {
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
            let samples: Vec<f64> = self.samples().map(|(t, _)| *t).filter(|&at| at > t).collect();
            let motion = self.followed((t, state), &samples, Task::default());
            let why = motion.stopped.as_ref().map(ToString::to_string);
            match self.compared((t, &groups[from..]), &motion, &mut error) {
                Ok(()) => match why {
                    Some(why) => return Verdict::NotJudged { why },
                    None => return Verdict::Agrees { error },
                },
                // Later events are compared from the run's own states on.
                Err(Divergence { agreed: 0, t: at, what }) => {
                    let first = groups.first().filter(|_| from == 0);
                    match first.map_or(Ok(false), |first| self.is_sensitive((t, state), first, &motion)) {
                        Ok(true) => {
                            from = 1;
                            continue;
                        }
                        Ok(false) => {}
                        Err(why) => return Verdict::NotJudged { why: why.to_string() },
                    }
                    return match why {
                        Some(why) if motion.events.is_empty() => Verdict::NotJudged { why },
                        _ => Verdict::Disagrees { t: at, what },
                    };
                }
                Err(Divergence { agreed, .. }) => from += agreed,
            }
        }
        Verdict::NotJudged { why: "the motion parts from its neighbours again and again".to_owned() }
    }

    /// Whether the first event is the same, and no later or earlier than errors of the run's steps
    /// at the start make it; why that is not known where the neighbour is not followed so far.
    fn is_sensitive(
        &self,
        (t, state): (f64, &[f64]),
        other: &Group,
        motion: &Motion,
    ) -> Result<bool, NotJudged> {
        let units = self.record.units.iter().take(state.len() / 2);
        let aside = units.map(|unit| ASIDE * unit).chain(core::iter::repeat(0.0));
        let moved: Vec<f64> = state.iter().zip(aside).map(|(x, aside)| x + aside).collect();
        let neighbour = self.followed((t, &moved), &[], Task::default());
        let first = |motion: &Motion| self.judged(t, &[], motion).into_iter().next();
        let Some(own) = first(motion) else { return Ok(false) };
        let Some(near) = first(&neighbour) else { return neighbour.stopped.map_or(Ok(false), Err) };
        let same = |a: &Group, b: &Group| a.changes == b.changes && a.contacts == b.contacts;
        let grown = (near.t - own.t).abs() * ERRORS * self.record.tolerance / ASIDE;
        let alike = self.record.apart(&own.state, &other.state) <= self.record.within;
        Ok(alike && same(&own, other) && same(&own, &near) && (own.t - other.t).abs() <= grown)
    }

    /// Compares from a time on; how far they are apart is taken in as long as they agree.
    fn compared(
        &self,
        (from, groups): (f64, &[Group]),
        motion: &Motion,
        error: &mut f64,
    ) -> Result<(), Divergence> {
        let judged = self.judged(from, groups, motion);
        let last = motion.samples.last().map_or(from, |(last, _)| *last);
        let reached = if motion.stopped.is_some() { last } else { f64::INFINITY };
        let mut states = self.states(from, motion).into_iter().peekable();
        for k in 0..=groups.len().max(judged.len()) {
            let (own, other) = (judged.get(k), groups.get(k));
            let until = earlier(own, other) - TOGETHER * self.record.time;
            while let Some((t, apart)) = states.next_if(|(t, _)| *t < until) {
                if apart > self.record.within {
                    return Err(Divergence {
                        agreed: k,
                        t,
                        what: format!("the states are {apart:.1e} apart"),
                    });
                }
                *error = error.max(apart);
            }
            let apart = self.paired((own, other), reached);
            match apart.map_err(|what| Divergence { agreed: k, t: earlier(own, other), what })? {
                Some(apart) => *error = error.max(apart),
                None => return Ok(()),
            }
        }
        Ok(())
    }

    /// When both have a state, and how far those are apart.
    fn states(&self, from: f64, motion: &Motion) -> Vec<(f64, f64)> {
        let mut recorded = self.samples().filter(|(t, _)| *t > from).peekable();
        let mut all = Vec::new();
        for (t, state) in &motion.samples {
            if let Some((_, there)) = recorded.next_if(|(at, _)| at == t) {
                all.push((*t, self.record.apart(&doubles(state), there)));
            }
        }
        all
    }

    /// How far two events are apart; none where nothing is left to compare, an error where they are
    /// not the same.
    fn paired(
        &self,
        (own, other): (Option<&Group>, Option<&Group>),
        reached: f64,
    ) -> Result<Option<f64>, String> {
        let record = self.record;
        let at_end = |g: &Group| g.t > record.end - TOGETHER * record.time;
        // An end that is waited for has to be found.
        let excused = |g: &Group| at_end(g) && !g.changes.contains(&Change::Stop);
        let (own, other) = match (own, other) {
            (None, None) => return Ok(None),
            (None, Some(other)) if excused(other) || other.t > reached => return Ok(None),
            (Some(own), None) if at_end(own) => return Ok(None),
            (None, Some(other)) => return Err(format!("{} is not found", described(other))),
            (Some(own), None) => return Err(format!("{} is missed", described(own))),
            (Some(own), Some(other)) => (own, other),
        };
        let late = record.late(own.t, other.t);
        if late > record.within.max(TOGETHER) {
            return Err(format!("{}, not {}", described(own), described(other)));
        }
        let apart = if other.state.is_empty() { 0.0 } else { record.apart(&own.state, &other.state) };
        let both = |change: Change| own.changes.contains(&change) && other.changes.contains(&change);
        if apart > record.within || (both(Change::Open) && own.contacts != other.contacts) {
            return Err(format!("{}, not {}: {apart:.1e} apart", described(own), described(other)));
        }
        Ok(Some(apart.max(late)))
    }
}

fn earlier(own: Option<&Group>, other: Option<&Group>) -> f64 {
    own.into_iter().chain(other).map(|g| g.t).fold(f64::INFINITY, f64::min)
}
