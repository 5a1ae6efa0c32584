//! Runs before an independent judge, which shares neither equations nor contact decisions with
//! them.

mod conditions;
mod record;

use std::cell::RefCell;

use liftoff::{Audit, Trajectory};
use liftoff_core::model::Layout;
use liftoff_judge::{Judge, Motion, Record, Task};
use record::record;

pub(crate) use record::change_of;

pub use liftoff_judge::Verdict;

/// The most work that a judge takes, and in passing: some twenty seconds, and one.
const MOST_WORK: u64 = Task::WORK / 3;
const IN_PASSING: u64 = MOST_WORK / 20;
/// Of a run with more segments none is written down in passing.
const SEGMENTS: usize = 2000;

thread_local! {
    static WITNESSED: RefCell<Option<Witnessed>> = const { RefCell::new(None) };
}

/// What is kept of a run: for the judge, if it is not too long or judged already, and its audit.
struct Witnessed {
    testimony: Result<Testimony, Verdict>,
    audit: Audit,
}

/// What is found of a run.
#[derive(Clone, Debug)]
pub struct Opinion {
    /// By the judge.
    pub judge: Verdict,
    /// By the audit of the run itself.
    pub audit: Option<Audit>,
}

/// What an independent judge finds of a run, with supports that were held closed.
pub fn judge(run: &Trajectory, held: &[&str]) -> Verdict {
    ask(run, held, |judge, record| judge.verdict(record, MOST_WORK))
}

/// What must hold of any motion, asked of a run: no jump, no penetration, nothing that pulls, no
/// energy gained.
pub fn audit(run: &Trajectory, held: &[&str]) -> Verdict {
    ask(run, held, Judge::audit)
}

/// Keeps a run for a judge of what this thread does: the last one counts.
pub fn witness(run: &Trajectory, held: &[&str]) {
    let phases = run.segments().len();
    let testimony = match phases {
        0..=SEGMENTS => Testimony::from_run(run, held).ok_or_else(|| NOTHING.to_owned()),
        _ => Err(format!("{phases} phases are too many to be judged in passing")),
    };
    keep(run, testimony.map_err(|why| Verdict::NotJudged { why }));
}

/// The same with a judge who was asked already.
pub fn witness_judged(run: &Trajectory, verdict: Verdict) {
    keep(run, Err(verdict));
}

fn keep(run: &Trajectory, testimony: Result<Testimony, Verdict>) {
    let witnessed = Witnessed { testimony, audit: run.audit() };
    WITNESSED.with(|last| *last.borrow_mut() = Some(witnessed));
}

/// What is found, in passing, of the last run that this thread was a witness of; none if there was
/// none.
pub(crate) fn found() -> Option<Opinion> {
    let Witnessed { testimony, audit } = WITNESSED.with(RefCell::take)?;
    let judge = match testimony {
        Ok(testimony) => testimony.before(|judge, record| judge.verdict(record, IN_PASSING)),
        Err(verdict) => verdict,
    };
    Some(Opinion { judge, audit: Some(audit) })
}

/// What a judge is told of a run.
pub(crate) struct Testimony {
    layout: &'static Layout,
    parameters: Vec<f64>,
    record: Record,
}

impl Testimony {
    /// None of what did not begin.
    pub(crate) fn from_run(run: &Trajectory, held: &[&str]) -> Option<Self> {
        let record = record(run, held)?;
        Some(Self { layout: run.layout(), parameters: run.parameters().to_vec(), record })
    }

    fn judge(&self) -> Result<Judge, String> {
        let coordinates: Vec<&str> =
            self.layout.coordinates.iter().map(|coordinate| coordinate.name).collect();
        Judge::new(self.layout.declaration, &self.parameters, &coordinates).map_err(|error| error.to_string())
    }

    fn before(&self, ask: impl FnOnce(&Judge, &Record) -> Verdict) -> Verdict {
        match self.judge() {
            Ok(judge) => ask(&judge, &self.record),
            Err(why) => Verdict::NotJudged { why },
        }
    }

    /// The judge's own motion from where the run began, and the names of its contacts: with the
    /// terms and samples of a task; of the state only its kept entries count.
    pub(crate) fn followed(&self, task: Task) -> Result<(Motion, Vec<String>), String> {
        let judge = self.judge()?;
        let motion = judge.repeated(&self.record, Task { most_work: MOST_WORK, ..task });
        match &motion.stopped {
            Some(reason) => Err(reason.to_string()),
            None => Ok((motion, judge.contacts().map(str::to_owned).collect())),
        }
    }

    /// The conditions that are not left to the judge to find, though the run ends by one of them.
    pub(crate) fn given(&self) -> Option<&str> {
        self.record.given.as_deref()
    }
}

const NOTHING: &str = "there is no motion";

fn ask(run: &Trajectory, held: &[&str], ask: impl FnOnce(&Judge, &Record) -> Verdict) -> Verdict {
    match Testimony::from_run(run, held) {
        Some(testimony) => testimony.before(ask),
        None => Verdict::NotJudged { why: NOTHING.to_owned() },
    }
}
