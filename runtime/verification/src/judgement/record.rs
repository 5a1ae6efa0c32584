//! A run in plain numbers, as the judge is told of it.

use liftoff::__private::event::Guard;
use liftoff::{Event, EventKind, Note, Scales, Segment, Trajectory};
use liftoff_judge::{Action, Change, Condition, MotionSegment, Record, RecordedEvent};

use super::conditions::translated;

/// Where in a segment states are compared.
const INSIDE: [f64; 3] = [0.23, 0.5, 0.81];
/// Natural units relative to the largest entry: far above the error of a run at a tight tolerance,
/// far below what another decision makes. At a loose one errors are [`GROWN`] tolerances.
const WITHIN: f64 = 1e-6;
/// Tolerances of a run that its errors come to.
const GROWN: f64 = 1e4;

/// A run in plain numbers; none of what did not begin.
pub(super) fn record(run: &Trajectory, held: &[&str]) -> Option<Record> {
    let start = run.events().first()?;
    let layout = run.layout();
    let Scales { time, .. } = run.scales();
    let awaited = Awaited::from_run(run);
    let last = run.events().last();
    let barred = last.filter(|event| event.kind == EventKind::Close);
    let stop = |name: &&str| layout.contacts.iter().any(|c| c.stop && c.supports.contains(name));
    Some(Record {
        t: start.t,
        start: layout.public_state(&start.state).to_vec(),
        held: held.iter().map(|name| (*name).to_owned()).collect(),
        actions: run.events().iter().filter_map(|event| action(run, event)).collect(),
        conditions: awaited.conditions,
        given: awaited.given,
        is_barred: barred.is_some(),
        ends_at_impacts: barred.is_some_and(|event| !event.supports.iter().any(stop)),
        undecided: run
            .events()
            .iter()
            .filter(|event| event.is_undecided())
            .map(|event| (event.t, names(event)))
            .collect(),
        events: run.events().iter().filter_map(|event| convert_event(run, event)).collect(),
        segments: run.segments().iter().map(|segment| convert_segment(run, segment)).collect(),
        end: run.end_time(),
        units: run.scales().state(layout),
        time,
        tolerance: run.tolerance(),
        within: WITHIN.max(GROWN * run.tolerance()),
    })
}

/// Conditions that the judge is to find by itself, and the one that it is given where it cannot.
struct Awaited {
    conditions: Vec<(Condition, Option<f64>)>,
    given: Option<String>,
}

impl Awaited {
    fn from_run(run: &Trajectory) -> Self {
        let (mut conditions, mut given) = (Vec::new(), None);
        for (k, condition) in run.conditions().iter().enumerate() {
            let met = met(run, k);
            let translated = translated(condition, run).transpose();
            let Some(translated) = translated else { continue };
            match (translated, met) {
                (Ok(condition), None) => conditions.push((condition, None)),
                (Ok(condition), Some((t, None))) => conditions.push((condition, Some(t))),
                (Ok(condition), Some((t, Some(actions)))) if actions.len() == 1 => {
                    let action = actions.into_iter().next();
                    conditions.push((Condition { action, ..condition }, Some(t)));
                }
                // Several are done at once: when is taken from the run.
                (Ok(_), Some((_, Some(_)))) => {}
                (Err(feature), Some((_, None))) => given = Some(format!("`{condition}` asks for {feature}")),
                (Err(_), _) => {}
            }
        }
        Self { conditions, given }
    }
}

/// When a condition was met, and what was done: none where the run ended.
type Met = (f64, Option<Vec<Action>>);

fn met(run: &Trajectory, k: usize) -> Option<Met> {
    let condition = &run.conditions()[k];
    let stop = run.events().last().filter(|event| event.kind == EventKind::Stop);
    if let Some(stop) = stop.filter(|stop| stop.note.as_ref().is_some_and(|note| is_of(note, condition))) {
        return Some((stop.t, None));
    }
    let segments = run.segments();
    let ended = |&(at, _): &(usize, &Segment)| run.ended_by(at).contains(&Guard::Condition(k));
    let (_, segment) = segments.iter().enumerate().find(ended)?;
    let done = run.events().iter().filter(|event| event.t == segment.t1);
    Some((segment.t1, Some(done.filter_map(|event| action(run, event)).map(|(_, action)| action).collect())))
}

fn is_of(note: &Note, condition: &liftoff::Condition) -> bool {
    matches!(note, Note::Condition(met) if met == condition)
}
fn names(event: &Event) -> Vec<String> {
    event.supports.iter().map(|&name| name.to_owned()).collect()
}

fn action(run: &Trajectory, event: &Event) -> Option<(f64, Action)> {
    match event.kind {
        EventKind::Release | EventKind::Cut => Some((event.t, Action::Remove(names(event)))),
        EventKind::Impulse => {
            let applied = run.impulses().iter().find(|applied| applied.t == event.t)?;
            let point = (*run.layout().points.get(applied.point)?).to_owned();
            Some((event.t, Action::Impulse { point, impulse: applied.impulse }))
        }
        _ => None,
    }
}

fn convert_event(run: &Trajectory, event: &Event) -> Option<RecordedEvent> {
    let change = change_of(run, event)?;
    let state = run.layout().public_state(&event.state).to_vec();
    Some(RecordedEvent { t: event.t, change, contacts: names(event), state })
}

/// What an event is to the judge; none if it is nothing that changes a motion or that the judge
/// waits for.
pub(crate) fn change_of(run: &Trajectory, event: &Event) -> Option<Change> {
    Some(match event.kind {
        EventKind::Open | EventKind::Slack => Change::Open,
        EventKind::Impact | EventKind::Taut | EventKind::Close => Change::Impact,
        EventKind::Settle => Change::Settle,
        EventKind::SlideOff => Change::SlideOff,
        EventKind::Release | EventKind::Cut => Change::Remove,
        EventKind::Impulse => Change::Impulse,
        EventKind::Stop if is_found(run, event) => Change::Stop,
        _ => return None,
    })
}

/// Whether the judge is left to find what a run ended by.
fn is_found(run: &Trajectory, event: &Event) -> bool {
    match &event.note {
        Some(Note::Condition(condition)) => matches!(translated(condition, run), Ok(Some(_))),
        _ => false,
    }
}

/// The state at an event belongs to what follows it, the one before it to the segment that it ends.
fn convert_segment(run: &Trajectory, segment: &Segment) -> MotionSegment {
    let Segment { t0, t1, .. } = *segment;
    let inside = INSIDE.iter().map(|part| t0 + part * (t1 - t0));
    let times = core::iter::once(t0).chain(inside).chain([t1.next_down()]);
    let mut samples: Vec<(f64, Vec<f64>)> = Vec::new();
    for t in times {
        if samples.last().is_none_or(|(last, _)| *last < t) && t < t1 {
            samples.push((t, run.state(t)));
        }
    }
    MotionSegment { closed: segment.closed.iter().map(|&name| name.to_owned()).collect(), samples }
}
