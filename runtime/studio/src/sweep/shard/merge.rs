//! Shards made one table: every file is checked before any is written.

use super::gaps::Gaps;
use super::part::Part;
use super::{JOURNAL, Merged, Shard, shards_in};
use crate::sweep::SweepError;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// All shards of one sweep, files or all of a folder.
///
/// # Errors
/// A file is no shard, or of another sweep, model or version than the first; a shard is there
/// twice; shards or members are missing or damaged, all of which are told.
pub fn merge(paths: &[PathBuf]) -> Result<Merged, SweepError> {
    let (parts, begun) = parts(paths)?;
    let Some(first) = parts.values().next() else {
        let path = paths.first().cloned().unwrap_or_default();
        return Err(SweepError::Journal { path, reason: "has no shards that are whole".to_owned() });
    };
    let head = first.head.clone();
    let mut gaps = Gaps::new(&head);
    let is = |shard: &Shard, index| (shard.index(), shard.count()) == (index, head.shard.count());
    let mut failed = 0;
    for index in 0..head.shard.count() {
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
    match gaps.describe() {
        Some(text) => Err(SweepError::Gaps(text)),
        None => Ok(Merged::new(head, parts, failed)),
    }
}

/// The shards of these files and folders by their numbers, and what the names of journals say that
/// has been begun.
fn parts(paths: &[PathBuf]) -> Result<(BTreeMap<usize, Part>, Vec<Shard>), SweepError> {
    let (mut parts, mut begun) = (BTreeMap::<usize, Part>::new(), Vec::new());
    for path in paths {
        let (files, journals) = files(path)?;
        begun.extend(journals);
        for file in files {
            let part = Part::open(file)?;
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
