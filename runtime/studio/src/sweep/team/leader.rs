//! The process that leads: it gives out members, and computes as well.

use super::answer::Answer;
use super::order::Order;
use super::queue::{Pace, Queue};
use super::{Found, Given, TICK};
use crate::sweep::journal::{Identity, difference};
use crate::sweep::{Observation, SweepError};
use liftoff_processes::Processes;
use std::collections::BTreeSet;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Instant;

/// The process that leads the others of a sweep. They are let go when it is dropped.
pub struct Leader<'a> {
    processes: &'a dyn Processes,
    workers: Mutex<Vec<Worker>>,
}

/// What a worker is doing.
enum Worker {
    /// It has not said that it is ready.
    Coming,
    Idle(Pace),
    /// It computes these members.
    Busy(Pace, Vec<usize>, Instant),
    /// It sends no more.
    Gone,
}

/// What is to be computed.
pub(in crate::sweep) struct Work<'a> {
    pub(in crate::sweep) identity: &'a Identity,
    pub(in crate::sweep) observations: &'a [Observation],
    /// So many members, by their numbers from 0 on.
    pub(in crate::sweep) count: usize,
    pub(in crate::sweep) point: &'a (dyn Fn(usize) -> Vec<f64> + Sync),
    /// Computes members in this process.
    pub(in crate::sweep) compute: &'a (dyn Fn(&[Given]) -> Vec<Found> + Sync),
    /// Called with what came of a member, from any thread.
    pub(in crate::sweep) note: &'a (dyn Fn(Found) + Sync),
    /// Whether no more is to be given out.
    pub(in crate::sweep) is_cancelled: &'a (dyn Fn() -> bool + Sync),
    /// Gives out no more once this is true either.
    pub(in crate::sweep) stop: &'a AtomicBool,
}

impl Work<'_> {
    fn given(&self, members: &[usize]) -> Vec<Given> {
        members.iter().map(|member| (*member, (self.point)(*member))).collect()
    }

    fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed) || (self.is_cancelled)()
    }
}

impl<'a> Leader<'a> {
    /// Of these processes, of which this is the first.
    pub fn new(processes: &'a dyn Processes) -> Self {
        let workers = (1..processes.count()).map(|_| Worker::Coming).collect();
        Self { processes, workers: Mutex::new(workers) }
    }

    /// Has members computed until all are done, or nothing is given out any more.
    pub(in crate::sweep) fn share(&self, work: &Work<'_>) -> Result<(), SweepError> {
        let queue = Mutex::new(Queue::new(work.count, self.processes.count()));
        thread::scope(|scope| {
            let own = scope.spawn(|| compute(work, &queue));
            let served = self.serve(work, &queue);
            own.join().unwrap_or_else(|panic| resume_unwind(panic));
            served
        })
    }

    fn serve(&self, work: &Work<'_>, queue: &Mutex<Queue>) -> Result<(), SweepError> {
        let mut workers = self.workers.lock().unwrap_or_else(PoisonError::into_inner);
        let mut served = Ok(());
        while !is_over(work, &locked(queue)) {
            for (i, worker) in workers.iter_mut().enumerate() {
                self.order(i + 1, worker, work, queue);
            }
            let Some((rank, message)) = self.processes.receive(TICK) else { continue };
            let taken = workers[rank - 1].take(&message, work, queue);
            if let Err(reason) = taken {
                work.stop.store(true, Ordering::Relaxed);
                served = served.and(reason.map_or(Err(SweepError::Interrupted), |reason| {
                    Err(SweepError::Process { process: rank, reason })
                }));
            }
        }
        served
    }

    /// Gives members to a worker that has none.
    fn order(&self, rank: usize, worker: &mut Worker, work: &Work<'_>, queue: &Mutex<Queue>) {
        let Worker::Idle(pace) = *worker else { return };
        let members = next(work, queue, pace);
        if !members.is_empty() {
            self.processes.send(rank, &Order::Run(work.given(&members)).text());
            *worker = Worker::Busy(pace, members, Instant::now());
        }
    }
}

impl Worker {
    /// Takes a message of its; an error says why it takes no part, none that it was interrupted.
    fn take(&mut self, message: &str, work: &Work<'_>, queue: &Mutex<Queue>) -> Result<(), Option<String>> {
        let unknown = || Some("sends what is no answer".to_owned());
        let result = match Answer::parse(message, work.observations).ok_or_else(unknown) {
            Ok(Answer::Ready(identity)) => {
                *self = Self::Idle(Pace::UNKNOWN);
                return same(&identity, work.identity).map_err(Some);
            }
            Ok(Answer::Rows(found)) => {
                self.note(found, work, queue);
                return Ok(());
            }
            Ok(Answer::Left(found)) => {
                self.note(found, work, queue);
                Err(None)
            }
            Ok(Answer::Refused(reason)) => Err(Some(format!("cannot take part: {reason}"))),
            Ok(Answer::End) => Err(None),
            Err(reason) => Err(reason),
        };
        // What it has not done is not done.
        self.note(Vec::new(), work, queue);
        *self = Self::Gone;
        result
    }

    fn note(&mut self, found: Vec<Found>, work: &Work<'_>, queue: &Mutex<Queue>) {
        if let Self::Busy(pace, members, since) = std::mem::replace(self, Self::Idle(Pace::UNKNOWN)) {
            *self = Self::Idle(pace.after(found.len(), since.elapsed()));
            bring(members, found, work, queue);
        }
    }
}

impl Drop for Leader<'_> {
    /// Says that there is no more to do, and waits until every worker has heard it.
    fn drop(&mut self) {
        let count = self.processes.count();
        (1..count).for_each(|rank| self.processes.send(rank, &Order::End.text()));
        let mut left = count - 1;
        while left > 0 {
            let message = self.processes.receive(TICK);
            left -= usize::from(message.is_some_and(|(_, text)| text == Answer::End.text(0)));
        }
    }
}

/// Computes members in this process until none is left.
fn compute(work: &Work<'_>, queue: &Mutex<Queue>) {
    let mut pace = Pace::UNKNOWN;
    while !is_over(work, &locked(queue)) {
        let members = next(work, queue, pace);
        if members.is_empty() {
            thread::sleep(TICK);
            continue;
        }
        let since = Instant::now();
        let found = (work.compute)(&work.given(&members));
        pace = pace.after(found.len(), since.elapsed());
        bring(members, found, work, queue);
    }
}

fn next(work: &Work<'_>, queue: &Mutex<Queue>, pace: Pace) -> Vec<usize> {
    if work.is_stopped() { Vec::new() } else { locked(queue).take(pace.members()) }
}

/// Notes what came of these members; those that are missing are given out once more.
fn bring(members: Vec<usize>, found: Vec<Found>, work: &Work<'_>, queue: &Mutex<Queue>) {
    let taken = members.len();
    let mut missing: BTreeSet<usize> = members.into_iter().collect();
    for found in found {
        if missing.remove(&found.0) {
            (work.note)(found);
        }
    }
    locked(queue).bring(taken, missing);
}

fn is_over(work: &Work<'_>, queue: &Queue) -> bool {
    queue.is_done() || (queue.is_still() && work.is_stopped())
}

fn locked(queue: &Mutex<Queue>) -> MutexGuard<'_, Queue> {
    queue.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Refuses a worker of another build, or with another sweep.
fn same(identity: &str, own: &Identity) -> Result<(), String> {
    let found: Identity = serde_json::from_str(identity).map_err(|error| error.to_string())?;
    difference(&found, own).map_or(Ok(()), |text| Err(format!("computes another sweep: {text}")))
}
