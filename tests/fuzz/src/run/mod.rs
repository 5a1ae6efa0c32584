//! Runs of all models: random parameters, starts, plans, methods and tolerances.
//!
//! A run ends with a motion or a typed error, in time; its numbers are finite, its audit is clean,
//! its gaps are not negative and its energy does not grow. Some runs are made again in other units,
//! by another method or form, in two parts, or as the mirror image with both halves, and must be
//! the same motion.

mod compare;
mod draw;
mod relation;
mod sound;
mod task;

use liftoff::{RunError, Trajectory};
use liftoff_tests::random::Source;

use crate::subject::Fate;
use crate::{Finding, Subject};
pub use relation::Relation;
pub use task::Task;

/// Runs, each perhaps with another that must agree with it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Runs;

impl Subject for Runs {
    type Case = Task;

    fn generate(&self, seed: u64) -> Task {
        draw::task(&mut Source::new(seed))
    }

    fn check(&self, task: &Task) -> Result<Fate, Finding> {
        let Ok(simulation) = task.simulation() else { return Ok(vec!["refused"]) };
        match simulation.run() {
            Ok(run) => {
                sound::check(task, &run)?;
                Ok([vec!["ran"], relation::check(task, &run)?].concat())
            }
            Err(error) => stopped(task, &error),
        }
    }

    fn details(&self, task: &Task) -> String {
        match task.simulation().map(|simulation| simulation.run()) {
            Err(error) => format!("refused: {error}"),
            Ok(Ok(run)) => describe_run(&run),
            Ok(Err(error)) => format!("{}{}", describe_run(error.trajectory()), error.cause()),
        }
    }
}

/// Its events, phases and decisions, and its audit.
fn describe_run(run: &Trajectory) -> String {
    let events =
        run.events().iter().map(|event| format!("{event}\n    t = {:?}, {:?}\n", event.t, event.state));
    let segments = run.segments();
    let phases = segments
        .iter()
        .map(|s| format!("[{:?}, {:?}] {:?} {:?} {}\n", s.t0, s.t1, s.closed, s.form, s.choice.method));
    let log = run.log().iter().map(|entry| format!("{:?} {}\n", entry.t, entry.decision));
    events.chain(phases).chain(log).collect::<String>() + &format!("{}\n", run.audit())
}

/// A run that stopped short by what it found wrong itself says so; what it has computed until then
/// is to be right otherwise.
fn stopped(task: &Task, error: &RunError) -> Result<Fate, Finding> {
    use liftoff::RunCause::{
        Accumulation, Budget, Contact, Invariant, Jump, Limit, Loop, Stalled, Start, Step,
    };
    let fate = match error.cause() {
        Start(_) | Limit(_) => return Ok(vec!["refused"]),
        Invariant(_) => return Ok(vec!["stopped: invariant"]),
        Jump { .. } => return Ok(vec!["stopped: jump"]),
        Budget { .. } => "stopped: budget",
        Step(_) => "stopped: step",
        Contact { .. } => "stopped: contact",
        Loop { .. } => "stopped: loop",
        Accumulation { .. } => "stopped: accumulation",
        Stalled { .. } => "stopped: stalled",
        _ => "stopped: other",
    };
    if task.is_wild() {
        return Ok(vec![fate]);
    }
    sound::in_part(error.trajectory(), error.cause())
        .map_err(|Finding(text)| Finding(format!("{text}; {}", error.cause())))?;
    Ok(vec![fate])
}
