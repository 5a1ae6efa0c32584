//! A shard that is to be merged.

use super::found::Found;
use super::head::Head;
use super::lines::Lines;
use crate::sweep::SweepError;
use crate::sweep::journal::difference;
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// A shard that is to be merged.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) path: PathBuf,
    pub(super) head: Head,
}

impl Part {
    pub(super) fn open(path: PathBuf) -> Result<Self, SweepError> {
        let failed = |source| SweepError::File { doing: "read", path: path.clone(), source };
        let mut lines = Lines::new(BufReader::new(File::open(&path).map_err(failed)?));
        let first = lines.raw().map_err(failed)?.to_vec();
        let second = lines.raw().map_err(failed)?;
        let head = Head::parse(&first, second);
        let head = head.map_err(|reason| SweepError::Journal { path: path.clone(), reason })?;
        Ok(Self { path, head })
    }

    /// Refuses a shard of another sweep than the first.
    pub(super) fn check(&self, first: &Self) -> Result<(), SweepError> {
        let other = difference(&self.head.of_all(), &first.head.of_all());
        let names = || "its columns are others".to_owned();
        let other = other.or_else(|| (self.head.names != first.head.names).then(names));
        let reason = |text| format!("belongs to another sweep than {}: {text}", first.path.display());
        other
            .map_or(Ok(()), |text| Err(SweepError::Journal { path: self.path.clone(), reason: reason(text) }))
    }

    /// Its lines behind the head, read so many bytes at once.
    pub(super) fn rows(&self, size: usize) -> io::Result<Lines<BufReader<Reopened<'_>>>> {
        let file = Reopened { path: &self.path, at: 0 };
        let mut lines = Lines::new(BufReader::with_capacity(size, file));
        for _ in 0..2 {
            lines.raw()?;
        }
        Ok(lines)
    }

    pub(super) fn found(&self) -> Result<Found, SweepError> {
        let failed = |source| SweepError::File { doing: "read", path: self.path.clone(), source };
        let file = File::open(&self.path).map_err(failed)?;
        Found::load(&file, &self.head).map_err(failed)
    }
}

/// A file that is opened for every reading, since there may be more shards than files may be open.
pub(super) struct Reopened<'a> {
    path: &'a Path,
    at: u64,
}

impl Read for Reopened<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut file = File::open(self.path)?;
        file.seek(SeekFrom::Start(self.at))?;
        let count = file.read(buffer)?;
        self.at += count as u64;
        Ok(count)
    }
}
