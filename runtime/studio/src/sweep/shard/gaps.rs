//! What is missing of a sweep, told so that it can be run again.

use super::found::Found;
use super::head::Head;
use std::path::Path;

/// So many numbers and files are told.
const TOLD: usize = 10;

/// What is missing of a sweep.
pub(super) struct Gaps {
    shards: usize,
    members: usize,
    /// Shards to be run again.
    again: Vec<usize>,
    texts: Vec<String>,
    absent: Vec<usize>,
    begun: Vec<usize>,
    missing: usize,
}

impl Gaps {
    pub(super) fn new(head: &Head) -> Self {
        Self {
            shards: head.shard.count(),
            members: head.members,
            again: Vec::new(),
            texts: Vec::new(),
            absent: Vec::new(),
            begun: Vec::new(),
            missing: 0,
        }
    }

    /// A shard whose file is not there; begun where it has a journal.
    pub(super) fn absent(&mut self, index: usize, is_begun: bool) {
        self.again.push(index);
        self.missing += self.members.saturating_sub(index).div_ceil(self.shards);
        if is_begun { self.begun.push(index) } else { self.absent.push(index) }
    }

    /// A shard that is not as it was written.
    pub(super) fn damaged(&mut self, path: &Path, head: &Head, found: &Found) {
        self.again.push(head.shard.index());
        let missing = found.missing().count();
        self.missing += missing;
        let numbers: Vec<String> =
            found.missing().take(TOLD).map(|place| head.shard.member(place).to_string()).collect();
        let more = if missing > TOLD { ", …" } else { "" };
        let text = match missing {
            0 => "is not as it was written".to_owned(),
            _ => format!(
                "is not whole: {missing} of its {} members are missing, {}{more}",
                head.share(),
                numbers.join(", ")
            ),
        };
        self.texts.push(format!("{} {text}", path.display()));
    }

    /// All of it in a line, if anything is missing.
    pub(super) fn describe(mut self) -> Option<String> {
        if self.again.is_empty() {
            return None;
        }
        let dropped = self.texts.len().saturating_sub(TOLD);
        self.texts.truncate(TOLD);
        if dropped > 0 {
            self.texts.push(format!("{dropped} more are not whole"));
        }
        for (indices, state) in [(&self.absent, "not there"), (&self.begun, "not finished")] {
            match &indices[..] {
                [] => {}
                [index] => self.texts.push(format!("shard {index} is {state}")),
                many => self.texts.push(format!("shards {} are {state}", ranges(many))),
            }
        }
        Some(format!(
            "{} of {} members are missing: {}; run again: --shard i/{}, --array={}",
            self.missing,
            self.members,
            self.texts.join("; "),
            self.shards,
            ranges(&self.again)
        ))
    }
}

/// Rising numbers as Slurm has them: `3,5-7`.
fn ranges(numbers: &[usize]) -> String {
    let mut parts: Vec<[usize; 2]> = Vec::new();
    for &number in numbers {
        match parts.last_mut() {
            Some([_, last]) if *last + 1 == number => *last = number,
            _ => parts.push([number; 2]),
        }
    }
    let part = |[first, last]: &[usize; 2]| {
        if first == last { first.to_string() } else { format!("{first}-{last}") }
    };
    parts.iter().map(part).collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::ranges;

    #[test]
    fn neighbours_are_one_range() {
        assert_eq!(ranges(&[0, 1, 2, 4, 6, 7]), "0-2,4,6-7");
        assert_eq!(ranges(&[3]), "3");
    }
}
