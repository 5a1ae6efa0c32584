//! What is done of a sweep, kept as it is done: a line that identifies the sweep, the names of the
//! columns, then a line for each member in the order in which they ended, with a checksum.
//!
//! One process at a time writes a journal. What is not as it was written is dropped, to be computed
//! once more.

mod head;
mod row;

use super::cell::Outcome;
use super::{Observation, SweepError};
pub(super) use head::{FOREIGN, FORM, Identity, MARK, difference, identity_of, may_be_ours, recorded, same};
use row::Rows;
pub(super) use row::{SEED, checksum, line, outcome, record, sealed, unsealed, written};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{BufWriter, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What is lost at most when a program is killed.
const AT_MOST: Duration = Duration::from_millis(200);

/// A journal that is written.
pub(super) struct Journal {
    file: BufWriter<File>,
    path: PathBuf,
    flushed: Instant,
    seed: u64,
}

/// What a journal has of a sweep.
#[derive(Default)]
pub(super) struct Known {
    /// Members that are done.
    pub(super) done: Vec<(usize, Outcome)>,
    /// How many lines were not as they had been written.
    pub(super) damaged: usize,
}

impl Journal {
    /// Opens the journal of a sweep, for this process alone, and reads what is done of it. A last
    /// line that was not written to its end and damaged lines are taken away.
    pub(super) fn open(
        path: &Path,
        identity: &Identity,
        observations: &[Observation],
        fresh: bool,
    ) -> Result<(Self, Known), SweepError> {
        let failed = |doing| move |source| SweepError::File { doing, path: path.to_owned(), source };
        let refused = |reason: String| SweepError::Journal { path: path.to_owned(), reason };
        let mut file = alone(path)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(failed("read"))?;
        if !head::may_be_ours(&bytes) {
            return Err(refused(head::FOREIGN.into()));
        }
        let [first, columns] = head::lines(identity, observations);
        let seed = row::checksum(row::SEED, first.as_bytes());
        let (kept, rows) = match bytes.iter().position(|byte| *byte == b'\n') {
            Some(end) if !fresh => {
                head::same(&bytes[..end], identity).map_err(refused)?;
                Rows::parse(&bytes, &format!("{first}\n{columns}"), seed, observations)
            }
            _ => (0, Rows::default()),
        };
        file.set_len(kept as u64).map_err(failed("write"))?;
        file.seek(SeekFrom::End(0)).map_err(failed("write"))?;
        let mut text = if kept == 0 { format!("{first}\n{columns}") } else { String::new() };
        text.push_str(&rows.moved);
        file.write_all(text.as_bytes()).map_err(failed("write"))?;
        Ok((Self::at_end(file, path, seed), rows.known))
    }

    /// A journal that goes on at the end of what it has.
    pub(super) fn at_end(file: File, path: &Path, seed: u64) -> Self {
        Self { file: BufWriter::new(file), path: path.to_owned(), flushed: Instant::now(), seed }
    }

    /// What its lines begin their checksums with.
    pub(super) fn seed(&self) -> u64 {
        self.seed
    }

    /// Notes a line; what is noted is in the file a little later, and at the end.
    pub(super) fn append(&mut self, line: &str) -> Result<(), SweepError> {
        let late = self.flushed.elapsed() > AT_MOST;
        let written = self.file.write_all(line.as_bytes());
        written.and_then(|()| if late { self.file.flush() } else { Ok(()) }).map_err(self.failed())?;
        if late {
            self.flushed = Instant::now();
        }
        Ok(())
    }

    /// Writes what has been noted.
    pub(super) fn flush(&mut self) -> Result<(), SweepError> {
        self.file.flush().map_err(self.failed())
    }

    /// The file with all that has been noted.
    pub(super) fn file(&self) -> &File {
        self.file.get_ref()
    }

    fn failed(&self) -> impl Fn(std::io::Error) -> SweepError + use<> {
        let path = self.path.clone();
        move |source| SweepError::File { doing: "write", path: path.clone(), source }
    }
}

/// Opens a file of a sweep, made where it is not there, for this process alone.
pub(super) fn alone(path: &Path) -> Result<File, SweepError> {
    let failed = |doing| move |source| SweepError::File { doing, path: path.to_owned(), source };
    let refused = |reason: &str| SweepError::Journal { path: path.to_owned(), reason: reason.to_owned() };
    if std::fs::metadata(path).is_ok_and(|what| !what.is_file()) {
        return Err(refused("is no file, and cannot be a journal"));
    }
    let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
    let file = file.map_err(failed("write"))?;
    lock(&file).map_err(failed("lock"))?.ok_or_else(|| refused(BUSY))?;
    Ok(file)
}

const BUSY: &str = "is the journal of a sweep that is running: wait for its end or name another file";

/// Whether nobody else has the file; yes where the file system has no locks.
fn lock(file: &File) -> std::io::Result<Option<()>> {
    match file.try_lock() {
        Ok(()) => Ok(Some(())),
        Err(TryLockError::WouldBlock) => Ok(None),
        Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => Ok(Some(())),
        Err(TryLockError::Error(error)) => Err(error),
    }
}
