//! Sums of many terms into canonical order: pending terms are sorted and merged in bulk, which is
//! several times cheaper than an ordered map when this code itself runs unoptimised.

use super::{Rational, Series, Term, work};
use std::cmp::Ordering;

type Entry = (Term, Rational);

/// Terms merged at once, at least; more when the sum has grown larger.
pub(super) const BATCH: usize = 1024;

/// From this ratio of lengths on, the shorter list is inserted into the longer term by term.
const SPARSE: usize = 16;

/// A sum under construction.
#[derive(Default)]
pub(super) struct Collector {
    sorted: Vec<Entry>,
    pub(super) pending: Vec<Entry>,
    overflow: bool,
}

impl Collector {
    /// A sum expected to receive about that many terms.
    pub(super) fn with_capacity(terms: usize) -> Self {
        Self { pending: Vec::with_capacity(terms.min(BATCH)), ..Self::default() }
    }

    /// Adds coefficient · term.
    pub(super) fn push(&mut self, term: Term, coefficient: Rational) {
        if !work::spend(1) {
            return self.poison();
        }
        self.pending.push((term, coefficient));
        if self.pending.len() >= BATCH.max(2 * self.sorted.len()) {
            self.flush();
        }
    }

    /// Marks the whole sum as overflow.
    pub(super) fn poison(&mut self) {
        self.overflow = true;
    }

    /// The canonical sum.
    pub(super) fn finish(mut self) -> Series {
        self.flush();
        if self.overflow { Series::overflow() } else { Series::from_sorted(self.sorted) }
    }

    fn flush(&mut self) {
        let mut batch = std::mem::take(&mut self.pending);
        batch.sort_unstable_by(|a, b| a.0.cmp(&b.0));
        batch.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 += next.1;
            }
            same
        });
        batch.retain(|entry| !entry.1.is_zero());
        self.sorted = merge(std::mem::take(&mut self.sorted), batch);
        self.overflow |= self.sorted.iter().any(|entry| entry.1.is_overflow());
    }
}

impl Series {
    /// The sum of coefficient · term over what `emit` pushes; overflow if `self` is.
    pub(super) fn collect(&self, emit: impl FnOnce(&mut Collector)) -> Self {
        if self.is_overflow() {
            return Self::overflow();
        }
        let mut sum = Collector::with_capacity(self.entries().len());
        emit(&mut sum);
        sum.finish()
    }
}

/// The sum of two sorted lists, each without equal terms.
pub(super) fn merge(left: Vec<Entry>, right: Vec<Entry>) -> Vec<Entry> {
    let (short, long) = match left.len().cmp(&right.len()) {
        Ordering::Less => (left, right),
        _ => (right, left),
    };
    if SPARSE * short.len() <= long.len() {
        return insert(long, short);
    }
    interleave(long, short)
}

fn insert(mut long: Vec<Entry>, short: Vec<Entry>) -> Vec<Entry> {
    for entry in short {
        match long.binary_search_by(|present| present.0.cmp(&entry.0)) {
            Err(at) => long.insert(at, entry),
            Ok(at) => {
                long[at].1 += entry.1;
                if long[at].1.is_zero() {
                    long.remove(at);
                }
            }
        }
    }
    long
}

fn interleave(left: Vec<Entry>, right: Vec<Entry>) -> Vec<Entry> {
    let mut merged = Vec::with_capacity(left.len());
    let mut right = right.into_iter();
    let mut waiting = right.next();
    for mut entry in left {
        while let Some(candidate) = waiting.take() {
            match candidate.0.cmp(&entry.0) {
                Ordering::Less => merged.push(candidate),
                Ordering::Equal => entry.1 += candidate.1,
                Ordering::Greater => {
                    waiting = Some(candidate);
                    break;
                }
            }
            waiting = right.next();
        }
        if !entry.1.is_zero() {
            merged.push(entry);
        }
    }
    merged.extend(waiting);
    merged.extend(right);
    merged
}
