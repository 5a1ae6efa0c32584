//! A sweep that processes share, those of `mpirun` for instance: the first leads, the others work
//! for it.
//!
//! The leader has the journal, the table and all files, and computes as well. It gives out points
//! in batches of about [`BATCH`](queue::BATCH) by the pace of the last one; whoever brings a batch
//! back is given the next. What a batch has not begun when it has taken four times as long goes to
//! another process, so that runs of very uneven length keep all of them at work. Points and what
//! was observed are sent with the fewest digits that read as the same number: rows are bit for bit
//! those of one process.

pub(super) mod answer;
mod leader;
pub(super) mod order;
mod queue;

pub use leader::Leader;
pub(super) use leader::Work;
pub(super) use queue::LIMIT;

use super::Outcome;
use std::time::Duration;

/// What a process waits for a message before it looks at other things.
pub(super) const TICK: Duration = Duration::from_millis(1);

/// A member by its number among those to be computed, with the values of the varied names.
pub(super) type Given = (usize, Vec<f64>);
/// What came of it.
pub(super) type Found = (usize, Outcome);
