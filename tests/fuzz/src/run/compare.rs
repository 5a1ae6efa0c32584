//! Two ways to one motion: whether both come to the same as their tolerances go to zero.
//!
//! Motions part at what they cannot decide, and neighbours part by themselves. So each way is
//! computed at two tolerances, and with parameters that round otherwise: where these differ the
//! comparison ends, and by how much they differ is what the ways may differ by.

use core::ops::RangeInclusive;

use liftoff::{Event, EventKind, LoggedDecision, Trajectory};

use crate::Finding;

/// An error of a start that grows so many times lies with the motion: it parts from its neighbours.
const UNSTABLE: f64 = 1e4;

/// Impacts of two halves that are this much of the natural time apart would be simultaneous.
const AT_ONCE: f64 = 1e-6;
/// Impacts that die away more slowly than this are not taken for one sequence.
const SLOWEST: f64 = 1e-2;

/// The events of a motion, in the time of the one that it is compared with.
#[derive(Clone, Debug)]
pub(super) struct Course {
    events: Vec<(EventKind, Vec<&'static str>, f64)>,
    /// From when until when the last of infinitely many impacts were left out.
    endings: Vec<RangeInclusive<f64>>,
    /// The natural time.
    time: f64,
    /// How far it comes, and how fast, in natural units, where that is less than one: what is to be
    /// decided by less is known to fewer digits, for tolerances are in natural units.
    extent: f64,
    /// From here on the run itself says that it might as well have gone on otherwise.
    undecided: f64,
}

impl Course {
    /// Events of a run; times t as (t + shift) · unit.
    pub fn from_run(run: &Trajectory, unit: f64, shift: f64) -> Self {
        let place = |t: f64| (t + shift) * unit;
        let told = run.log().iter().filter(|entry| doubtful(&entry.decision)).map(|entry| entry.t);
        let touched = run.events().iter().filter(|event| event.is_undecided()).map(|event| event.t);
        let undecided = told.chain(touched).fold(f64::INFINITY, f64::min);
        let ends = settling(run);
        let is_last =
            |event: &&Event| comes_again(event.kind) && ends.iter().any(|end| end.contains(&event.t));
        let moved = run.events().iter().filter(|event| counts(event.kind) && !is_last(event));
        let events = moved.map(|event| (event.kind, event.supports.clone(), place(event.t))).collect();
        let endings = ends.iter().map(|end| place(*end.start())..=place(*end.end())).collect();
        let extent = extent(run);
        Self { events, endings, time: run.scales().time * unit, extent, undecided: place(undecided) }
    }

    /// Without what has happened until a time.
    pub fn after(mut self, t: f64) -> Self {
        self.events.retain(|(_, _, at)| *at > t);
        self
    }

    /// Not looked at from a time on.
    pub fn until(mut self, t: f64) -> Self {
        self.undecided = self.undecided.min(t);
        self
    }

    /// Without the last of infinitely many impacts of another course: which are the last is a
    /// matter of natural units, which a start from another state has others of.
    fn without_last_of(mut self, other: &[RangeInclusive<f64>]) -> Self {
        self.events.retain(|(kind, _, t)| !(comes_again(*kind) && other.iter().any(|end| end.contains(t))));
        self
    }

    /// Events without their supports: of two halves that meet the floor at once rounding lets one
    /// be first.
    pub fn nameless(mut self) -> Self {
        self.events.iter_mut().for_each(|(_, supports, _)| supports.clear());
        self
    }

    /// Events at one time as one: the two halves of a symmetric motion do the same at once.
    pub fn united(mut self, within: f64) -> Self {
        let mut united: Vec<(EventKind, Vec<&'static str>, f64)> = Vec::new();
        for (kind, supports, t) in self.events {
            match united.last_mut() {
                Some((last, all, at)) if *last == kind && t - *at < within * self.time => {
                    all.extend(supports);
                    all.sort_unstable();
                    all.dedup();
                }
                _ => united.push((kind, supports, t)),
            }
        }
        self.events = united;
        self
    }
}

/// Two courses, of infinitely many impacts without those that are the last ones of either.
pub(super) fn paired([one, other]: [Course; 2]) -> [Course; 2] {
    let [last, others] = [&one, &other].map(|course| course.endings.clone());
    [one.without_last_of(&others), other.without_last_of(&last)]
}

/// From after which event a motion differs from its neighbour, whose start differs by `nudge`, by
/// more than [`UNSTABLE`] times that, in natural units: what follows is made of rounding.
pub(super) fn parts_from([own, neighbour]: [&Trajectory; 2], nudge: f64) -> f64 {
    let n = own.layout().coordinates.len();
    let units = &own.scales().state(own.layout())[..2 * n];
    let apart = |a: &[f64], b: &[f64]| {
        units
            .iter()
            .zip(a.iter().zip(b))
            .fold(0.0, |most: f64, (unit, (a, b))| most.max((a - b).abs() / unit))
    };
    let pairs = own.events().iter().zip(neighbour.events());
    let together =
        pairs.clone().take_while(|(a, b)| a.kind == b.kind && apart(&a.state, &b.state) <= UNSTABLE * nudge);
    let count = together.count();
    let last = count.checked_sub(1).map_or(0.0, |k| own.events()[k].t);
    if count < pairs.len() { last.next_up() } else { f64::INFINITY }
}

/// How far a motion comes from its start, and how fast, by its events; at most one.
fn extent(run: &Trajectory) -> f64 {
    let (units, events) = (run.scales().state(run.layout()), run.events());
    let n = run.layout().coordinates.len();
    let of = |event: &Event| {
        let start = |i: usize| if i < n { events[0].state[i] } else { 0.0 };
        (0..2 * n).fold(0.0, |most: f64, i| most.max((event.state[i] - start(i)).abs() / units[i]))
    };
    events.iter().map(of).fold(0.0, f64::max).min(1.0)
}

/// Of infinitely many impacts how many are made before their end is a matter of tolerance, where
/// they are lower than that: from the natural time of such a flight on, or so many of the last ones
/// as are near to the end for how slowly they die away.
fn settling(run: &Trajectory) -> Vec<RangeInclusive<f64>> {
    let events = run.events();
    let low = 10.0 * (10.0 * run.tolerance()).sqrt() * run.scales().time;
    let ends = events.iter().enumerate().filter(|(_, event)| event.kind == EventKind::Settle);
    let from = |(k, end): (usize, &Event)| {
        let before =
            events[..k].iter().rev().filter(|event| event.kind == EventKind::Impact).map(|event| event.t);
        let last: Vec<f64> = before.take(3).collect();
        let slow = match last[..] {
            [c, b, a] if b > a && c > b => low / (1.0 - (c - b) / (b - a)).max(SLOWEST),
            _ => low,
        };
        end.t - slow.max(low)..=end.t
    };
    ends.map(from).collect()
}

/// What alternates with impacts on the way to a settle.
fn comes_again(kind: EventKind) -> bool {
    matches!(kind, EventKind::Impact | EventKind::Open)
}

/// From when on the order of impacts that would be simultaneous without rounding may have decided,
/// as the log tells it of those that are.
pub(super) fn struck_in_turn(run: &Trajectory) -> f64 {
    let impacts: Vec<&Event> = run.events().iter().filter(|event| event.kind == EventKind::Impact).collect();
    let near = AT_ONCE * run.scales().time;
    let in_turn = |pair: &&[&Event]| pair[0].supports != pair[1].supports && pair[1].t - pair[0].t < near;
    impacts.windows(2).find(in_turn).map_or(f64::INFINITY, |pair| pair[0].t.next_up())
}

/// Touches come and go with the tolerance.
fn counts(kind: EventKind) -> bool {
    !matches!(kind, EventKind::Start | EventKind::Touch)
}

fn doubtful(decision: &LoggedDecision) -> bool {
    use LoggedDecision::{GuardUnresolved, ImpactOrder, ImpulsesNotUnique, RestitutionScaled};
    matches!(decision, GuardUnresolved | ImpactOrder(_) | ImpulsesNotUnique | RestitutionScaled(_))
}

/// Whether two courses are the same within this part of the time.
///
/// # Errors
/// Where they are not.
pub(super) fn same([one, other]: [&Course; 2], within: f64) -> Result<(), Finding> {
    parted([one, other], |_| within).map_or(Ok(()), |i| Err(Finding(describe_difference([one, other], i))))
}

/// The first event in which two courses differ by more than this part of the time.
fn parted([one, other]: [&Course; 2], within: impl Fn(usize) -> f64) -> Option<usize> {
    let undecided = one.undecided.min(other.undecided);
    // By its own clock: the other way may be late.
    let past =
        |course: &Course, i: usize| course.events.get(i).is_some_and(|event| event.2 >= course.undecided);
    for i in 0..one.events.len().max(other.events.len()) {
        let (a, b) = (one.events.get(i), other.events.get(i));
        let at = [a, b].into_iter().flatten().map(|event| event.2).fold(f64::INFINITY, f64::min);
        if at >= undecided || past(one, i) || past(other, i) {
            return None;
        }
        match (a, b) {
            (Some(a), Some(b)) if a.0 == b.0 && a.1 == b.1 => {
                if (a.2 - b.2).abs() > within(i) * a.2.abs().max(one.time) {
                    return Some(i);
                }
            }
            _ => return Some(i),
        }
    }
    None
}

fn describe_difference([one, other]: [&Course; 2], i: usize) -> String {
    let part = |course: &Course| {
        let events = course.events.iter().skip(i.saturating_sub(1)).take(3);
        let told: Vec<_> =
            events.map(|(kind, supports, t)| format!("{} {kind} {t:?}", supports.join(","))).collect();
        told.join("; ")
    };
    format!("event {i}: [{}] or [{}]", part(one), part(other))
}

/// Courses of the two ways at a fine tolerance, and those of the same ways at a coarse one and with
/// parameters that round otherwise: whether both ways are known, and not to be the same.
///
/// # Errors
/// Where they part.
pub(super) fn converged(fine: &[Course; 2], known_by: &[[Course; 2]], floor: f64) -> Result<(), Finding> {
    let pairs = || known_by.iter().flat_map(|others| fine.iter().zip(others));
    let apart = |(a, b): (&Course, &Course), i: usize| match (a.events.get(i), b.events.get(i)) {
        (Some(x), Some(y)) => (x.2 - y.2).abs() / x.2.abs().max(a.time),
        _ => f64::INFINITY,
    };
    let [one, other] = fine;
    let within = |i: usize| {
        let all = (0..=i).flat_map(|k| pairs().map(move |pair| apart(pair, k)));
        floor / one.extent.max(f64::MIN_POSITIVE) + 30.0 * all.fold(0.0, f64::max)
    };
    let known = pairs().filter_map(|(a, b)| parted([a, b], |_| 1e-3)).min();
    let Some(i) = parted([one, other], within) else { return Ok(()) };
    if known.is_some_and(|known| i >= known) {
        return Ok(());
    }
    Err(Finding(describe_difference([one, other], i)))
}
