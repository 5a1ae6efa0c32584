//! Computes a shard.

use super::found::Found;
use super::head::Head;
use super::store::{Store, check};
use super::{Shard, Share, shards_in};
use crate::sweep::{Outcome, Sweep, SweepError, table};
use std::fs::{self, File};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

impl Sweep<'_> {
    /// Runs those members of a shard that its files in this folder do not have. What is done is
    /// kept as it is done; once all is, the shard's file is written.
    pub fn run_shard(&self, shard: Shard, folder: &Path) -> Result<Share, SweepError> {
        let (plan, points) = self.prepared()?;
        let columns = (table::head(&self.varied, &self.observations), self.columns());
        let head = Head::new(self.identity(), columns, shard, points.len());
        let failed = |source| SweepError::File { doing: "write", path: folder.to_owned(), source };
        fs::create_dir_all(folder).map_err(failed)?;
        of_one_division(folder, shard)?;
        let (file, journal) = (shard.file(folder), shard.journal(folder));
        let mut store = Store::open(&journal, head.clone(), self.fresh)?;
        // The journal is this process's alone, and so is the shard.
        crate::file::remove_left(&file).map_err(failed)?;
        if let Some(found) = known_of(&file, &head, self.fresh)? {
            if found.is_whole() {
                let whole =
                    Share { done: found.done, failed: found.failed, ..self.share(&store, file, journal, 0) };
                store.discard();
                return Ok(Share { computed: 0, damaged: 0, ..whole });
            }
            store.take(&file)?;
        }
        let known = store.done;
        let pending = store.pending();
        let member = |i: usize| shard.member(pending[i] as usize);
        let kept = Mutex::new(store);
        let on_result = |i: usize, outcome: Outcome| {
            let line =
                table::line(member(i), &points.compute_point(member(i)), &outcome, self.observations.len());
            let mut store = kept.lock().unwrap_or_else(PoisonError::into_inner);
            store.note(pending[i] as usize, &line)?;
            if let Some(on_progress) = self.progress {
                on_progress(store.done, head.share());
            }
            Ok(())
        };
        let ran = plan.run(&|i| points.compute_point(member(i)), pending.len(), &on_result);
        let mut store = kept.into_inner().unwrap_or_else(PoisonError::into_inner);
        store.flush()?;
        ran?;
        let share = self.share(&store, file, journal, known);
        if share.is_whole() {
            store.finish(&share.file)?;
        }
        Ok(share)
    }

    fn share(&self, store: &Store, file: PathBuf, journal: PathBuf, known: usize) -> Share {
        let Head { shard, members: total, .. } = store.head;
        Share {
            shard,
            file,
            journal,
            model: self.model().name().to_owned(),
            total,
            members: store.head.share(),
            done: store.done,
            computed: store.done - known,
            failed: store.failed,
            damaged: store.damaged,
        }
    }
}

/// What the file of a shard has, where it is there and is not to be written afresh.
fn known_of(path: &Path, head: &Head, fresh: bool) -> Result<Option<Found>, SweepError> {
    let failed = |source| SweepError::File { doing: "read", path: path.to_owned(), source };
    let file = match File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(failed(error)),
    };
    check(&file, path, head, fresh)?;
    if fresh { Ok(None) } else { Found::load(&file, head).map(Some).map_err(failed) }
}

/// Refuses a folder that has shards of as many as these are not.
fn of_one_division(folder: &Path, shard: Shard) -> Result<(), SweepError> {
    let failed = |source| SweepError::File { doing: "read", path: folder.to_owned(), source };
    let found = shards_in(folder).map_err(failed)?;
    let Some((path, other)) = found.into_iter().find(|(_, other)| other.count != shard.count) else {
        return Ok(());
    };
    let reason = format!(
        "is of {} shards, not of {}: say --shard i/{0}, or name another folder",
        other.count, shard.count
    );
    Err(SweepError::Journal { path, reason })
}
