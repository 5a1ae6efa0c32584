//! Shards made one table: every file is checked first, then their lines are taken in turn.

use super::found::Found;
use super::gaps::Gaps;
use super::head::Head;
use super::lines::{Line, Lines};
use super::{JOURNAL, Merged, Shard, shards_in};
use crate::sweep::SweepError;
use crate::sweep::journal::difference;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Bytes of all shards that are read at once, and of each at most and at least.
const AT_ONCE: usize = 32 << 20;
const OF_EACH: [usize; 2] = [4 << 10, 256 << 10];

/// A shard to be merged.
struct Part {
    path: PathBuf,
    head: Head,
}

/// Merges shards, files or all of a folder, and writes the table of the whole sweep to a file, where one is given: byte for byte
/// that of one process.
///
/// # Errors
/// A file is no shard, or of another sweep, model or version than the first; a shard is there twice; shards or members are
/// missing or damaged, all of which are told. Nothing is written then.
pub fn merge(paths: &[PathBuf], csv: Option<&Path>) -> Result<Merged, SweepError> {
    let (parts, begun) = parts(paths)?;
    let Some(first) = parts.values().next() else {
        let path = paths.first().cloned().unwrap_or_default();
        return Err(SweepError::Journal { path, reason: "has no shards that are whole".to_owned() });
    };
    let mut gaps = Gaps::new(&first.head);
    let is = |shard: &Shard, index| (shard.index(), shard.count()) == (index, first.head.shard.count());
    let mut failed = 0;
    for index in 0..first.head.shard.count() {
        match parts.get(&index) {
            None => gaps.absent(index, begun.iter().any(|shard| is(shard, index))),
            Some(part) => {
                let found = part.found()?;
                failed += found.failed;
                if !found.is_whole() {
                    gaps.damaged(&part.path, &part.head, &found);
                }
            }
        }
    }
    gaps.told().map_or(Ok(()), |text| Err(SweepError::Gaps(text)))?;
    if let Some(csv) = csv {
        let failed = |source| SweepError::File { doing: "write", path: csv.to_owned(), source };
        crate::file::replace(csv, |out| write(&parts, &first.head, out)).map_err(failed)?;
    }
    let Head { shard, members, .. } = first.head;
    Ok(Merged { model: first.head.model().to_owned(), members, shards: shard.count(), failed })
}

/// The shards of these files and folders by their numbers, and what the names of journals say that has been begun.
fn parts(paths: &[PathBuf]) -> Result<(BTreeMap<usize, Part>, Vec<Shard>), SweepError> {
    let (mut parts, mut begun) = (BTreeMap::<usize, Part>::new(), Vec::new());
    for path in paths {
        let (files, journals) = files(path)?;
        begun.extend(journals);
        for file in files {
            let part = Part::read(file)?;
            if let Some((_, first)) = parts.first_key_value() {
                part.check(first)?;
            }
            let index = part.head.shard.index();
            if let Some(other) = parts.insert(index, part) {
                let reason = format!("is shard {index} as {} is", other.path.display());
                return Err(SweepError::Journal { path: parts[&index].path.clone(), reason });
            }
        }
    }
    Ok((parts, begun))
}

/// The shards of a folder that are whole, and those that have a journal; or the one file.
fn files(path: &Path) -> Result<(Vec<PathBuf>, Vec<Shard>), SweepError> {
    if !path.is_dir() {
        return Ok((vec![path.to_owned()], Vec::new()));
    }
    let failed = |source| SweepError::File { doing: "read", path: path.to_owned(), source };
    let found = shards_in(path).map_err(failed)?;
    let (journals, files): (Vec<_>, Vec<_>) =
        found.into_iter().partition(|(path, _)| path.to_string_lossy().ends_with(JOURNAL));
    Ok((files.into_iter().map(|(path, _)| path).collect(), journals.into_iter().map(|(_, s)| s).collect()))
}

impl Part {
    fn read(path: PathBuf) -> Result<Self, SweepError> {
        let failed = |source| SweepError::File { doing: "read", path: path.clone(), source };
        let mut lines = Lines::new(BufReader::new(File::open(&path).map_err(failed)?));
        let first = lines.raw().map_err(failed)?.to_vec();
        let second = lines.raw().map_err(failed)?;
        let head = Head::read(&first, second);
        let head = head.map_err(|reason| SweepError::Journal { path: path.clone(), reason })?;
        Ok(Self { path, head })
    }

    /// Refuses a shard of another sweep than the first.
    fn check(&self, first: &Self) -> Result<(), SweepError> {
        let other = difference(&self.head.of_all(), &first.head.of_all());
        let columns = || "its columns are others".to_owned();
        let other = other.or_else(|| (self.head.columns != first.head.columns).then(columns));
        let reason = |text| format!("is of another sweep than {}: {text}", first.path.display());
        other
            .map_or(Ok(()), |text| Err(SweepError::Journal { path: self.path.clone(), reason: reason(text) }))
    }

    /// Its lines behind the head, read so many bytes at once.
    fn rows(&self, size: usize) -> io::Result<Lines<BufReader<Reopened<'_>>>> {
        let file = Reopened { path: &self.path, at: 0 };
        let mut lines = Lines::new(BufReader::with_capacity(size, file));
        for _ in 0..2 {
            lines.raw()?;
        }
        Ok(lines)
    }

    fn found(&self) -> Result<Found, SweepError> {
        let failed = |source| SweepError::File { doing: "read", path: self.path.clone(), source };
        let file = File::open(&self.path).map_err(failed)?;
        Found::read(&file, &self.head).map_err(failed)
    }
}

/// Writes the table; what is not as it has just been found makes it fail.
fn write(parts: &BTreeMap<usize, Part>, head: &Head, out: &mut dyn Write) -> io::Result<()> {
    let [least, most] = OF_EACH;
    let size = (AT_ONCE / parts.len()).clamp(least, most);
    let readers = parts.values().map(|part| part.rows(size));
    let mut readers = readers.collect::<io::Result<Vec<_>>>()?;
    out.write_all(head.columns.as_bytes())?;
    for member in 0..head.members {
        let (index, place) = (member % parts.len(), member / parts.len());
        match readers[index].next(&parts[&index].head)? {
            Some(Line::Member(at, line)) if at == place => {
                out.write_all(line.as_bytes())?;
                out.write_all(b"\n")?;
            }
            _ => return Err(io::Error::new(ErrorKind::InvalidData, "a shard has changed meanwhile")),
        }
    }
    Ok(())
}

/// A file that is opened for every reading, since there may be more shards than files may be open.
struct Reopened<'a> {
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
