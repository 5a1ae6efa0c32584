//! The lines of a shard, one after the other, in memory that does not grow with their number.

use super::head::Head;
use crate::sweep::journal::unsealed;
use std::io::{self, BufRead, Read};

/// Bytes of a line; what is longer is read as several, which are damaged.
const LONGEST: u64 = 16 << 20;

/// A line behind the head.
#[derive(PartialEq, Eq, Debug)]
pub(super) enum Line<'a> {
    /// A member at this place in the shard: its line of the table, without the end.
    Member(usize, &'a str),
    /// What says that all are there.
    Last,
    /// Not as it was written, or of another shard.
    Damaged,
    /// Not written to its end.
    Torn,
}

/// Reads lines, of which each is taken once.
pub(super) struct Lines<R> {
    reader: R,
    line: Vec<u8>,
    /// Bytes before the line.
    pub(super) start: u64,
}

impl<R: BufRead> Lines<R> {
    pub(super) fn new(reader: R) -> Self {
        Self { reader, line: Vec::new(), start: 0 }
    }

    /// The next line with its end, if it has one; empty at the end of the file.
    pub(super) fn raw(&mut self) -> io::Result<&[u8]> {
        self.start += self.line.len() as u64;
        self.line.clear();
        self.reader.by_ref().take(LONGEST).read_until(b'\n', &mut self.line)?;
        Ok(&self.line)
    }

    /// The next line of the shard with this head; none at the end of the file.
    pub(super) fn next(&mut self, head: &Head) -> io::Result<Option<Line<'_>>> {
        self.raw()?;
        if self.line.is_empty() {
            return Ok(None);
        }
        Ok(Some(understood(&self.line, head)))
    }
}

fn understood<'a>(line: &'a [u8], head: &Head) -> Line<'a> {
    if !line.ends_with(b"\n") {
        return Line::Torn;
    }
    match unsealed(line, head.seed) {
        None => Line::Damaged,
        Some(text) if text == head.last() => Line::Last,
        Some(text) => {
            let member = text.split(',').next().and_then(|member| member.parse().ok());
            let place = member.filter(|member| *member < head.members).and_then(|m| head.shard.find_row(m));
            place.map_or(Line::Damaged, |place| Line::Member(place, text))
        }
    }
}

/// Whether a line of the table is that of a member that failed: its last field, the reason, is not
/// empty.
pub(super) fn is_failed(line: &str) -> bool {
    !line.ends_with(',')
}
