//! Runs before an independent judge, which shares neither equations nor contact decisions with them.

use core::time::Duration;
use std::cell::RefCell;

use liftoff::event::EventKind;
use liftoff::model::Layout;
use liftoff::{Event, Scales, Segment, Trajectory};
use liftoff_judge::{Action, Change, Happening, Judge, Record, Stretch};

pub use liftoff_judge::Verdict;

/// Where in a segment states are compared.
const INSIDE: [f64; 3] = [0.23, 0.5, 0.81];
/// Natural units relative to the largest entry: far above the error of a run at a tight tolerance, far below what another
/// decision makes. At a loose one errors are [`GROWN`] tolerances.
const WITHIN: f64 = 1e-6;
/// Tolerances of a run that its errors come to.
const GROWN: f64 = 1e4;
/// The most time that a judge takes, and in passing.
const PATIENCE: Duration = Duration::from_secs(20);
const IN_PASSING: Duration = Duration::from_secs(2);
/// Of a run with more segments none is written down in passing.
const SEGMENTS: usize = 400;

thread_local! {
    static WITNESSED: RefCell<Option<Testimony>> = const { RefCell::new(None) };
}

/// What an independent judge finds of a run, with supports that were held closed.
pub fn judge(run: &Trajectory, held: &[&str]) -> Verdict {
    ask(run, held, |judge, record| judge.verdict(record, PATIENCE))
}

/// What must hold of any motion, asked of a run: no jump, no penetration, nothing that pulls, no energy gained.
pub fn audit(run: &Trajectory, held: &[&str]) -> Verdict {
    ask(run, held, Judge::audit)
}

/// Keeps a run for a judge of what this thread does: the last one counts.
pub fn witness(run: &Trajectory, held: &[&str]) {
    let short = run.segments().len() <= SEGMENTS;
    let testimony = if short { Testimony::of(run, held) } else { None };
    WITNESSED.with(|witnessed| *witnessed.borrow_mut() = testimony);
}

/// What the judge finds, in passing, of the last run that this thread was a witness of; none if there was none.
pub(crate) fn found() -> Option<Verdict> {
    let testimony = WITNESSED.with(RefCell::take)?;
    Some(testimony.before(|judge, record| judge.verdict(record, IN_PASSING)))
}

/// What a judge is told of a run.
struct Testimony {
    layout: &'static Layout,
    parameters: Vec<f64>,
    record: Record,
}

impl Testimony {
    fn of(run: &Trajectory, held: &[&str]) -> Option<Self> {
        let record = record(run, held)?;
        Some(Self { layout: run.layout(), parameters: run.parameters().to_vec(), record })
    }

    fn before(&self, ask: impl FnOnce(&Judge, &Record) -> Verdict) -> Verdict {
        let coordinates: Vec<&str> =
            self.layout.coordinates.iter().map(|coordinate| coordinate.name).collect();
        match Judge::of(self.layout.declaration, &self.parameters, &coordinates) {
            Ok(judge) => ask(&judge, &self.record),
            Err(reason) => Verdict::NotJudged { why: reason.to_string() },
        }
    }
}

fn ask(run: &Trajectory, held: &[&str], ask: impl FnOnce(&Judge, &Record) -> Verdict) -> Verdict {
    match Testimony::of(run, held) {
        Some(testimony) => testimony.before(ask),
        None => Verdict::NotJudged { why: "there is no motion".to_owned() },
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
        within: WITHIN.max(GROWN * run.tolerance()),
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
