//! Workers kept busy for a given time, each in a process of its own.

use std::collections::BTreeMap;
use std::io::{self, BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use crate::worker::{Line, Order};

/// How long, and with what.
#[derive(Clone, Debug)]
pub struct Campaign {
    /// What is tried: the name of a subcommand of this program.
    pub subject: &'static str,
    /// The first seed.
    pub seed: u64,
    /// For how long.
    pub time: Duration,
    /// Most cases.
    pub cases: u64,
    /// How many processes at once.
    pub jobs: usize,
    /// When a case counts as a hang.
    pub limit: Duration,
    /// What a worker may use of memory, KiB.
    pub memory: u64,
    /// Seeds of one worker process.
    pub range: u64,
}

/// Seeds with what is wrong.
pub type Found = Vec<(u64, String)>;

/// What came of it.
#[derive(Debug, Default)]
pub struct Outcome {
    /// How many cases were tried.
    pub cases: u64,
    /// Seeds with what is wrong.
    pub findings: Found,
    /// How many had which fate.
    pub fates: Fates,
}

/// Counts of fates.
pub type Fates = BTreeMap<String, u64>;

/// What one process told.
struct Told {
    reached: u64,
    found: Found,
    fates: Fates,
    /// Whether it came to its end.
    ended: bool,
}

impl Outcome {
    fn add(&mut self, found: &Found, fates: Fates) {
        self.findings.extend(found.iter().cloned());
        fates.into_iter().for_each(|(fate, count)| *self.fates.entry(fate).or_default() += count);
    }
}

impl Campaign {
    /// Runs it; each finding is given to `tell` at once.
    ///
    /// # Errors
    /// A process cannot be started.
    pub fn run(&self, tell: impl Fn(u64, &str) + Sync) -> io::Result<Outcome> {
        let (next, began) = (AtomicU64::new(self.seed), Instant::now());
        let outcome = Mutex::new(Outcome::default());
        let end = self.seed.saturating_add(self.cases);
        let job = || -> io::Result<()> {
            while began.elapsed() < self.time {
                let from = next.fetch_add(self.range, Ordering::Relaxed);
                if from >= end {
                    break;
                }
                let part = self.range(from, end.min(from + self.range), began + self.time, &tell)?;
                if let Ok(mut outcome) = outcome.lock() {
                    outcome.cases += part.cases;
                    outcome.add(&part.findings, part.fates);
                }
            }
            Ok(())
        };
        std::thread::scope(|scope| {
            let jobs: Vec<_> = (0..self.jobs).map(|_| scope.spawn(job)).collect();
            jobs.into_iter().try_for_each(|job| job.join().unwrap_or(Ok(())))
        })?;
        let mut outcome = outcome.into_inner().unwrap_or_default();
        outcome.findings.sort();
        Ok(outcome)
    }

    /// Tries a range, over the deaths of its workers.
    fn range(
        &self,
        mut from: u64,
        to: u64,
        deadline: Instant,
        tell: &impl Fn(u64, &str),
    ) -> io::Result<Outcome> {
        let (start, mut outcome, mut trace) = (from, Outcome::default(), false);
        while from < to && Instant::now() < deadline {
            let order = Order { from, to, limit: self.limit, trace };
            let Told { reached, found, fates, ended } = self.worker(order, deadline)?;
            let hang = found.last().filter(|(seed, _)| !ended && *seed >= reached).map(|(seed, _)| *seed);
            found.iter().for_each(|(seed, text)| tell(*seed, text));
            outcome.add(&found, fates);
            (from, trace) = match (ended, hang) {
                (true, _) => (to, false),
                (false, _) if Instant::now() >= deadline => (reached, false),
                (false, Some(seed)) => (seed + 1, false),
                (false, None) if trace => {
                    let text = "the process died: stack overflow, abort or out of memory";
                    tell(reached, text);
                    outcome.findings.push((reached, text.to_owned()));
                    (reached + 1, false)
                }
                (false, None) => (reached, true),
            };
        }
        outcome.cases = from - start;
        Ok(outcome)
    }

    /// One process.
    fn worker(&self, order: Order, deadline: Instant) -> io::Result<Told> {
        let mut child = self.command(order)?.stdout(Stdio::piped()).stderr(Stdio::null()).spawn()?;
        let mut told = Told { reached: order.from, found: Vec::new(), fates: Fates::new(), ended: false };
        if let Some(out) = child.stdout.take() {
            for line in BufReader::new(out).lines() {
                match Line::parse(&line?) {
                    Some(Line::Reached(seed)) => told.reached = seed,
                    Some(Line::Found(seed, text)) => told.found.push((seed, text)),
                    Some(Line::Fate(count, fate)) => *told.fates.entry(fate).or_default() += count,
                    None => {}
                }
                if Instant::now() > deadline {
                    child.kill()?;
                    child.wait()?;
                    return Ok(told);
                }
            }
        }
        let status = child.wait()?;
        // What the shell says of a program that is not there any more, as while it is built anew.
        if matches!(status.code(), Some(126 | 127)) {
            return Err(io::Error::other("the program cannot be started once more"));
        }
        told.ended = status.success();
        Ok(told)
    }

    /// This program as a worker, its memory bounded where a shell can do that.
    fn command(&self, order: Order) -> io::Result<Command> {
        let program: PathBuf = std::env::current_exe()?;
        let mut command = if cfg!(unix) {
            let mut shell = Command::new("sh");
            shell.args(["-c", &format!("ulimit -v {}; exec \"$0\" \"$@\"", self.memory)]).arg(program);
            shell
        } else {
            Command::new(program)
        };
        let (from, to) = (order.from.to_string(), order.to.to_string());
        let limit = order.limit.as_secs_f64().to_string();
        command.args([self.subject, "--from", &from, "--to", &to, "--limit", &limit]);
        if order.trace {
            command.arg("--trace");
        }
        Ok(command)
    }
}
