//! What a run may take.

use std::time::{Duration, Instant};

use thiserror::Error;

/// What a run may take at most. A run that takes more stops with
/// [`RunCause::Budget`](crate::RunCause::Budget) and the motion so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Budget {
    /// Accepted and rejected steps.
    pub steps: u64,
    /// Events, impacts among them.
    pub events: usize,
    /// Impacts within one natural time: sequences of them that end are cut short, others may go on
    /// for ever.
    pub impacts: usize,
    /// Sets of contacts tried in one decision about accelerations or impulses, which only rough and
    /// jamming contacts need.
    pub trials: usize,
    /// Memory of the recorded motion, bytes.
    pub memory: usize,
    /// Time that the run takes on the clock, looked at between steps. A run without this limit
    /// reads no clock.
    pub time: Option<Duration>,
}

impl Budget {
    /// No limits.
    pub const UNLIMITED: Self = Self {
        steps: u64::MAX,
        events: usize::MAX,
        impacts: usize::MAX,
        trials: usize::MAX,
        memory: usize::MAX,
        time: None,
    };
}

/// A hundred million steps, two hundred thousand events, fifty thousand impacts in a natural time,
/// as many trials in a decision, a gibibyte of recorded motion, and any time: more than any run
/// that is meant.
impl Default for Budget {
    fn default() -> Self {
        Self {
            steps: 100_000_000,
            events: 200_000,
            impacts: 50_000,
            trials: 50_000,
            memory: 1 << 30,
            time: None,
        }
    }
}

/// What a run took too much of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum Exhausted {
    /// Steps.
    #[error("{0} steps")]
    Steps(u64),
    /// Events.
    #[error("{0} events")]
    Events(usize),
    /// Impacts within one natural time.
    #[error("{0} impacts within one natural time")]
    Impacts(usize),
    /// Sets of contacts tried in one decision.
    #[error("{0} sets of contacts tried in one decision")]
    Trials(usize),
    /// Memory of the recorded motion, bytes.
    #[error("{} of recorded motion", memory(*.0))]
    Memory(usize),
    /// Time on the clock.
    #[error("{0:?} on the clock")]
    Time(Duration),
}

/// Bytes in the largest unit that they are some of.
fn memory(bytes: usize) -> String {
    let units = [(1 << 30, "GiB"), (1 << 20, "MiB"), (1 << 10, "KiB")];
    let unit =
        units.into_iter().find(|(size, _)| bytes >= 10 * size || bytes > 0 && bytes.is_multiple_of(*size));
    unit.map_or_else(|| format!("{bytes} bytes"), |(size, name)| format!("{} {name}", bytes / size))
}

/// A budget, and what has been spent of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Allowance {
    pub(crate) budget: Budget,
    steps: u64,
    memory: usize,
    end: Option<Instant>,
}

impl Allowance {
    /// All of it, from now on.
    pub(crate) fn new(budget: Budget) -> Self {
        let end = budget.time.and_then(|time| Instant::now().checked_add(time));
        Self { budget, steps: 0, memory: 0, end }
    }

    /// Takes note of what a phase needed.
    pub(crate) fn spend(&mut self, steps: u64, memory: usize) {
        self.steps = self.steps.saturating_add(steps);
        self.memory = self.memory.saturating_add(memory);
    }

    /// The whole of what a phase with so many steps and so much memory takes too much of.
    pub(crate) fn exceeded_by(&self, steps: u64, memory: usize) -> Option<Exhausted> {
        if self.steps.saturating_add(steps) > self.budget.steps {
            return Some(Exhausted::Steps(self.budget.steps));
        }
        if self.memory.saturating_add(memory) > self.budget.memory {
            return Some(Exhausted::Memory(self.budget.memory));
        }
        let is_late = self.end.is_some_and(|end| Instant::now() >= end);
        self.budget.time.filter(|_| is_late).map(Exhausted::Time)
    }
}
