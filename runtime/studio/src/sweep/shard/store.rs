//! What is done of a shard, kept as it is done, and the file that it becomes.

use super::found::Found;
use super::head::Head;
use super::lines::{Line, Lines, is_failed};
use crate::sweep::SweepError;
use crate::sweep::journal::{FOREIGN, Journal, alone, may_be_ours, same, sealed};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Bytes that are read at once.
pub(super) const AT_ONCE: usize = 1 << 16;

/// What is done of a shard: 8 bytes a member in memory, the rest in its journal.
pub(super) struct Store {
    pub(super) head: Head,
    path: PathBuf,
    journal: Journal,
    /// Bytes of the journal.
    end: u64,
    /// Where in the journal the line of each member is, the head is at 0.
    places: Vec<u64>,
    /// How many members are done, how many of these have failed, how many lines were not as they
    /// had been written.
    pub(super) done: usize,
    pub(super) failed: usize,
    pub(super) damaged: usize,
}

impl Store {
    /// Opens the journal of a shard, for this process alone. A last line that was not written to
    /// its end is taken away.
    pub(super) fn open(path: &Path, head: Head, fresh: bool) -> Result<Self, SweepError> {
        let failed = |doing| move |source| SweepError::File { doing, path: path.to_owned(), source };
        let mut file = alone(path)?;
        check(&file, path, &head, fresh)?;
        if fresh {
            file.set_len(0).map_err(failed("write"))?;
        }
        let text = head.text();
        let mut found = Found::load(&file, &head).map_err(failed("read"))?;
        if found.done == 0 {
            found.end = text.len() as u64;
            file.set_len(0).and_then(|()| file.rewind()).map_err(failed("write"))?;
            file.write_all(text.as_bytes()).map_err(failed("write"))?;
        }
        file.set_len(found.end).map_err(failed("write"))?;
        file.seek(SeekFrom::End(0)).map_err(failed("write"))?;
        let Found { places, end, done, failed, damaged, .. } = found;
        let journal = Journal::at_end(file, path, head.seed);
        Ok(Self { head, path: path.to_owned(), journal, end, places, done, failed, damaged })
    }

    /// The places of the members that are not done.
    pub(super) fn pending(&self) -> Vec<u32> {
        let places = self.places.iter().enumerate().filter(|(_, start)| **start == 0);
        places.filter_map(|(place, _)| u32::try_from(place).ok()).collect()
    }

    /// Notes the line of the table of the member at a place.
    pub(super) fn note(&mut self, place: usize, line: &str) -> Result<(), SweepError> {
        if self.places[place] != 0 {
            return Ok(());
        }
        let text = sealed(line, self.head.seed);
        self.journal.append(&text)?;
        self.places[place] = self.end;
        self.end += text.len() as u64;
        self.done += 1;
        self.failed += usize::from(is_failed(line.trim_end_matches('\n')));
        Ok(())
    }

    /// Notes what is whole of a file of the same shard.
    pub(super) fn take(&mut self, path: &Path) -> Result<(), SweepError> {
        let failed = |source| SweepError::File { doing: "read", path: path.to_owned(), source };
        let mut lines = Lines::new(BufReader::new(File::open(path).map_err(failed)?));
        let head = self.head.clone();
        for _ in 0..2 {
            lines.raw().map_err(failed)?;
        }
        while let Some(line) = lines.next(&head).map_err(failed)? {
            match line {
                Line::Member(place, text) => self.note(place, text)?,
                Line::Last => {}
                Line::Damaged | Line::Torn => self.damaged += 1,
            }
        }
        Ok(())
    }

    /// Writes what has been noted.
    pub(super) fn flush(&mut self) -> Result<(), SweepError> {
        self.journal.flush()
    }

    /// Writes the whole shard to its file, then removes the journal.
    pub(super) fn finish(self, target: &Path) -> Result<(), SweepError> {
        let failed = |source| SweepError::File { doing: "write", path: target.to_owned(), source };
        crate::file::replace(target, |out| self.write(out)).map_err(failed)?;
        self.discard();
        Ok(())
    }

    /// Removes the journal of a shard that is whole; one that is left beside it does no harm.
    pub(super) fn discard(self) {
        let _ = std::fs::remove_file(&self.path);
    }

    /// The lines in the order of members; of what was done in turn the reading is in turn.
    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut file = self.journal.file().try_clone()?;
        file.rewind()?;
        let (mut reader, mut at) = (BufReader::with_capacity(AT_ONCE, file), 0);
        let mut line = Vec::new();
        out.write_all(self.head.text().as_bytes())?;
        for start in &self.places {
            reader.seek_relative(*start as i64 - at)?;
            line.clear();
            reader.by_ref().take(self.end - start).read_until(b'\n', &mut line)?;
            at = (start + line.len() as u64) as i64;
            out.write_all(&line)?;
        }
        out.write_all(sealed(&self.head.last(), self.head.seed).as_bytes())
    }
}

/// Refuses a file of something else, and that of another shard unless it is to be written afresh.
pub(super) fn check(file: &File, path: &Path, head: &Head, fresh: bool) -> Result<(), SweepError> {
    let mut lines = Lines::new(BufReader::new(file));
    let first =
        lines.raw().map_err(|source| SweepError::File { doing: "read", path: path.to_owned(), source })?;
    let refused = |reason| SweepError::Journal { path: path.to_owned(), reason };
    match first.strip_suffix(b"\n") {
        _ if !may_be_ours(first) => Err(refused(FOREIGN.to_owned())),
        Some(first) if !fresh => same(first, &head.identity).map_err(refused),
        _ => Ok(()),
    }
}
