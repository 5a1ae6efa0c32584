//! What came of a shard.

use super::Shard;
use std::fmt::Write;
use std::path::PathBuf;

/// What came of a shard.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Share {
    /// Which shard it is.
    pub shard: Shard,
    /// Its file, once it is whole.
    pub file: PathBuf,
    /// What is done of it, until it is whole.
    pub journal: PathBuf,
    /// The name of the model.
    pub model: String,
    /// Number of members of the whole sweep.
    pub total: usize,
    /// Number of members of the shard.
    pub members: usize,
    /// How many of these are done, and how many of those were computed now.
    pub done: usize,
    /// How many were computed now; files had the others.
    pub computed: usize,
    /// How many have failed.
    pub failed: usize,
    /// How many lines of files were not as they had been written; their members were computed once
    /// more.
    pub damaged: usize,
}

impl Share {
    /// Whether every member was run, and the shard's file written.
    pub fn is_whole(&self) -> bool {
        self.done == self.members
    }

    /// How many members, how many of them were computed, in a line or two.
    pub fn summary(&self) -> String {
        let Self { shard, model, total, members, computed, .. } = self;
        let mut text =
            format!("shard {shard} of {total} members of {model}: {members} members, {computed} computed");
        let counts =
            [(self.done - computed, "known"), (self.failed, "failed"), (members - self.done, "not run")];
        for (count, what) in counts.into_iter().filter(|(count, _)| *count > 0) {
            let _ = write!(text, ", {count} {what}");
        }
        match self.damaged {
            0 => {}
            1 => text += "; a damaged line was dropped",
            damaged => text += &format!("; {damaged} damaged lines were dropped"),
        }
        text + "\n"
    }
}
