//! What a file has of a shard.

use super::head::Head;
use super::lines::{Line, Lines, is_failed};
use std::fs::File;
use std::io::{self, BufReader, Seek};

/// What a file has of a shard.
#[derive(Default)]
pub(super) struct Found {
    /// Where the line of each member is; 0 of those that are not there.
    pub(super) places: Vec<u64>,
    /// Bytes up to the end of the last line that was written to its end.
    pub(super) end: u64,
    /// How many members there are, how many of these have failed, how many lines are not as they
    /// had been written.
    pub(super) done: usize,
    pub(super) failed: usize,
    pub(super) damaged: usize,
    /// Whether the file ends with the line that says that all are there, and has nothing else
    /// behind the members.
    is_closed: bool,
}

impl Found {
    /// Reads a file that begins with this head.
    pub(super) fn load(mut file: &File, head: &Head) -> io::Result<Self> {
        file.rewind()?;
        let mut lines = Lines::new(BufReader::new(file));
        // The head has been looked at.
        for _ in 0..2 {
            lines.raw()?;
        }
        let mut found = Self { places: vec![0; head.share()], ..Self::default() };
        while let Some(line) = lines.next(head)? {
            let closed = std::mem::replace(&mut found.is_closed, line == Line::Last);
            match line {
                Line::Torn => break,
                Line::Damaged => found.damaged += 1,
                Line::Last => found.damaged += usize::from(closed),
                Line::Member(place, text) => {
                    let failed = is_failed(text);
                    found.member(place, lines.start, failed);
                }
            }
        }
        found.end = lines.start;
        Ok(found)
    }

    fn member(&mut self, place: usize, start: u64, failed: bool) {
        if self.places[place] == 0 {
            self.places[place] = start;
            self.done += 1;
            self.failed += usize::from(failed);
        }
    }

    /// Whether it is a whole shard as it was written: every member, in order, and the last line.
    pub(super) fn is_whole(&self) -> bool {
        self.is_closed && self.damaged == 0 && self.done == self.places.len() && self.places.is_sorted()
    }

    /// The places of members that are not there.
    pub(super) fn missing(&self) -> impl Iterator<Item = usize> {
        self.places.iter().enumerate().filter(|(_, start)| **start == 0).map(|(place, _)| place)
    }
}
