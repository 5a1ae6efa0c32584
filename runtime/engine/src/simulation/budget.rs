//! What a run may take.

use thiserror::Error;

/// What a run may take at most. A run that takes more stops with [`RunCause::Budget`](crate::RunCause::Budget) and the motion so
/// far.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Budget {
    /// Accepted and rejected steps.
    pub steps: u64,
    /// Events, impacts among them.
    pub events: usize,
    /// Memory of the recorded motion, bytes.
    pub memory: usize,
}

impl Budget {
    /// No limits.
    pub const UNLIMITED: Self = Self { steps: u64::MAX, events: usize::MAX, memory: usize::MAX };
}

/// A hundred million steps, two hundred thousand events and a gibibyte of recorded motion: more than any run that is meant.
impl Default for Budget {
    fn default() -> Self {
        Self { steps: 100_000_000, events: 200_000, memory: 1 << 30 }
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
    /// Memory of the recorded motion, bytes.
    #[error("{} MiB of recorded motion", .0 >> 20)]
    Memory(usize),
}
