//! Runs before an independent judge, which shares neither equations nor contact decisions with them.

use core::time::Duration;

use liftoff::event::EventKind;
use liftoff::model::Layout;
use liftoff::{Event, Scales, Segment, Trajectory};
use liftoff_judge::{Action, Change, Happening, Judge, Record, Stretch};

pub use liftoff_judge::Verdict;

/// Where in a segment states are compared.
const INSIDE: [f64; 3] = [0.23, 0.5, 0.81];
/// Natural units relative to the largest entry: far above the error of a run at a tight tolerance, far below what another
/// decision makes.
const WITHIN: f64 = 1e-6;
/// The most time that a judge takes.
const PATIENCE: Duration = Duration::from_secs(30);

/// What an independent judge finds of a run, with supports that were held closed.
pub fn judge(run: &Trajectory, held: &[&str]) -> Verdict {
    before(run, held, |judge, record| judge.verdict(record, PATIENCE))
}

/// What must hold of any motion, asked of a run: no jump, no penetration, nothing that pulls, no energy gained.
pub fn audit(run: &Trajectory, held: &[&str]) -> Verdict {
    before(run, held, Judge::audit)
}

fn before(run: &Trajectory, held: &[&str], ask: impl FnOnce(&Judge, &Record) -> Verdict) -> Verdict {
    let layout = run.layout();
    let coordinates: Vec<&str> = layout.coordinates.iter().map(|coordinate| coordinate.name).collect();
    match Judge::of(layout.declaration, run.parameters(), &coordinates) {
        Ok(judge) => match record(run, held) {
            Some(record) => ask(&judge, &record),
            None => Verdict::NotJudged { why: "there is no motion".to_owned() },
        },
        Err(reason) => Verdict::NotJudged { why: reason.to_string() },
    }
}

/// A run in plain numbers.
fn record(run: &Trajectory, held: &[&str]) -> Option<Record> {
    let start = run.events().first()?;
    let layout = run.layout();
    let Scales { time, .. } = run.scales();
    Some(Record {
        t: start.t,
        start: layout.public_state(&start.state).to_vec(),
        held: held.iter().map(|name| (*name).to_owned()).collect(),
        actions: run.events().iter().filter_map(|event| action(run, event)).collect(),
        events: run.events().iter().filter_map(|event| happening(layout, event)).collect(),
        stretches: run.segments().iter().map(|segment| stretch(run, segment)).collect(),
        end: run.end_time(),
        units: run.scales().state(layout),
        time,
        within: WITHIN,
    })
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

fn happening(layout: &Layout, event: &Event) -> Option<Happening> {
    let change = match event.kind {
        EventKind::Open | EventKind::Slack => Change::Open,
        EventKind::Impact | EventKind::Taut | EventKind::Close => Change::Impact,
        EventKind::Settle => Change::Settle,
        EventKind::SlideOff => Change::SlideOff,
        EventKind::Release | EventKind::Cut => Change::Remove,
        EventKind::Impulse => Change::Impulse,
        EventKind::Start | EventKind::Touch | EventKind::Stop | EventKind::End => return None,
    };
    let ends = event.kind == EventKind::Close;
    let state = if ends { Vec::new() } else { layout.public_state(&event.state).to_vec() };
    Some(Happening { t: event.t, change, contacts: names(event), state })
}

/// The state at an event belongs to what follows it, the one before it to the segment that it ends.
fn stretch(run: &Trajectory, segment: &Segment) -> Stretch {
    let Segment { t0, t1, .. } = *segment;
    let inside = INSIDE.iter().map(|part| t0 + part * (t1 - t0));
    let times = core::iter::once(t0).chain(inside).chain([t1.next_down()]);
    let mut samples: Vec<(f64, Vec<f64>)> = Vec::new();
    for t in times {
        if samples.last().is_none_or(|(last, _)| *last < t) && t < t1 {
            samples.push((t, run.state(t)));
        }
    }
    Stretch { closed: segment.closed.iter().map(|&name| name.to_owned()).collect(), samples }
}
