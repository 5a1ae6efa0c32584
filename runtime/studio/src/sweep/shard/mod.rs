//! A sweep in parts that processes run by themselves, on one machine or on many, and that are
//! merged afterwards.
//!
//! Shard i of n has every n-th member from the i-th on: neighbours, whose runs are of about one
//! length, are in different shards, and merging takes a line of each in turn. While it is computed
//! a shard is a journal, whose lines are in the order in which members ended; a whole one is a file
//! with its lines in the order of members and a last line that says so, written aside and renamed.
//! Lines are those of the table with a checksum that is bound to the sweep, its shard and the
//! version.

mod found;
mod gaps;
mod head;
mod lines;
mod merge;
mod merged;
mod part;
mod run;
mod share;
mod store;

pub use merge::merge;
pub use merged::Merged;
pub use share::Share;

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Shards of a sweep.
pub const MOST_SHARDS: usize = 10_000;

/// One of the parts of a sweep.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Shard {
    index: usize,
    count: usize,
}

impl Shard {
    /// The shard with this index, from 0, of so many.
    ///
    /// # Errors
    /// There is none, in a line.
    pub fn new(index: usize, count: usize) -> Result<Self, String> {
        match count {
            0 => Err("no shards: one is the least".to_owned()),
            1..=MOST_SHARDS if index < count => Ok(Self { index, count }),
            1..=MOST_SHARDS => {
                Err(format!("no shard {index} of {count}: they are numbered from 0 to {}", count - 1))
            }
            _ => Err(format!("{count} shards: {MOST_SHARDS} are the most")),
        }
    }

    /// Its index, from 0.
    pub fn index(self) -> usize {
        self.index
    }

    /// How many shards there are.
    pub fn count(self) -> usize {
        self.count
    }

    /// How many of so many members it has.
    fn share(self, members: usize) -> usize {
        members.saturating_sub(self.index).div_ceil(self.count)
    }

    /// The member at this place in it.
    fn member(self, place: usize) -> usize {
        self.index + place * self.count
    }

    /// The place of a member in it.
    fn find_row(self, member: usize) -> Option<usize> {
        let behind = member.checked_sub(self.index)?;
        (behind % self.count == 0).then_some(behind / self.count)
    }

    /// Its file, once it is whole.
    fn file(self, folder: &Path) -> PathBuf {
        folder.join(format!("{}-of-{}{EXTENSION}", self.index, self.count))
    }

    /// What is done of it, until it is whole.
    fn journal(self, folder: &Path) -> PathBuf {
        folder.join(format!("{}-of-{}{EXTENSION}{JOURNAL}", self.index, self.count))
    }
}

/// The files of shards in a folder, whole or not, with what their names say, in the order of their
/// numbers.
fn shards_in(folder: &Path) -> io::Result<Vec<(PathBuf, Shard)>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        found.extend(named(&path).map(|shard| (path, shard)));
    }
    found.sort_by(|(a, one), (b, two)| (one.count, one.index, a).cmp(&(two.count, two.index, b)));
    Ok(found)
}

/// Which shard a file's name says that it is of.
fn named(path: &Path) -> Option<Shard> {
    let name = path.file_name()?.to_str()?;
    let stem = name.strip_suffix(JOURNAL).unwrap_or(name).strip_suffix(EXTENSION)?;
    let (index, count) = stem.split_once("-of-")?;
    Shard::new(index.parse().ok()?, count.parse().ok()?).ok()
}

const EXTENSION: &str = ".shard";
const JOURNAL: &str = ".journal";

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = String;

    /// Reads `i/n`.
    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text
            .split_once('/')
            .and_then(|(index, count)| Some((index.trim().parse().ok()?, count.trim().parse().ok()?)));
        let (index, count) = numbers.ok_or("expected i/n, the first is 0/n")?;
        Self::new(index, count)
    }
}
