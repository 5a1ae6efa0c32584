//! Which members are still to be given out, and how many at once.

use std::collections::VecDeque;
use std::time::Duration;

/// What a batch takes, about.
pub(super) const BATCH: Duration = Duration::from_millis(250);
/// A batch that takes longer begins no more of its members.
pub(in crate::sweep) const LIMIT: Duration = Duration::from_secs(1);
/// A batch has at most so many times as many members as the last one.
const GROWTH: usize = 4;

/// The members of a sweep that are still to be given out.
pub(super) struct Queue {
    next: usize,
    count: usize,
    /// Given out, and not begun.
    returned: VecDeque<usize>,
    /// How many are given out.
    open: usize,
    processes: usize,
}

impl Queue {
    /// Of so many members, for so many processes.
    pub(super) fn new(count: usize, processes: usize) -> Self {
        Self { next: 0, count, returned: VecDeque::new(), open: 0, processes }
    }

    /// So many members; fewer where little is left, so that all processes end at about one time.
    pub(super) fn take(&mut self, size: usize) -> Vec<usize> {
        let left = self.returned.len() + self.count - self.next;
        let size = size.min(left.div_ceil(2 * self.processes));
        let again = self.returned.drain(..size.min(self.returned.len()));
        let mut taken: Vec<usize> = again.collect();
        let fresh = size - taken.len();
        taken.extend(self.next..self.next + fresh);
        self.next += fresh;
        self.open += size;
        taken
    }

    /// Of so many members that were given out these have not been begun.
    pub(super) fn bring(&mut self, taken: usize, missing: impl IntoIterator<Item = usize>) {
        self.open -= taken;
        self.returned.extend(missing);
    }

    /// Whether nothing is given out.
    pub(super) fn is_still(&self) -> bool {
        self.open == 0
    }

    /// Whether all is done.
    pub(super) fn is_done(&self) -> bool {
        self.is_still() && self.returned.is_empty() && self.next == self.count
    }
}

/// How many members a process computes in a batch.
#[derive(Clone, Copy)]
pub(super) struct Pace(usize);

impl Pace {
    /// Of a process whose pace is not known.
    pub(super) const UNKNOWN: Self = Self(1);

    pub(super) fn members(self) -> usize {
        self.0
    }

    /// After a batch in which so many were computed in this time.
    pub(super) fn after(self, computed: usize, time: Duration) -> Self {
        let fitting = computed as f64 * BATCH.as_secs_f64() / time.as_secs_f64().max(1e-9);
        Self((fitting as usize).clamp(1, GROWTH * self.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_member_is_given_out_until_it_is_done() {
        let mut queue = Queue::new(100, 3);
        let mut done = Vec::new();
        while !queue.is_done() {
            let taken = queue.take(8);
            assert!(!taken.is_empty() && !queue.is_still());
            // The last of each batch is not begun, but where it is alone.
            let (computed, missing) = taken.split_at((taken.len() - 1).max(1));
            done.extend_from_slice(computed);
            queue.bring(taken.len(), missing.iter().copied());
        }
        done.sort_unstable();
        assert_eq!(done, (0..100).collect::<Vec<_>>());
    }

    #[test]
    fn little_is_left_to_all() {
        let mut queue = Queue::new(10, 2);
        let sizes: Vec<usize> = std::iter::from_fn(|| Some(queue.take(1000).len())).take(5).collect();
        assert_eq!(sizes, [3, 2, 2, 1, 1]);
    }

    #[test]
    fn batches_follow_the_pace() {
        let slow = Pace::UNKNOWN.after(1, Duration::from_secs(100));
        assert_eq!(slow.members(), 1);
        let quick = (0..20)
            .fold(Pace::UNKNOWN, |pace, _| pace.after(pace.0, Duration::from_micros(50) * pace.0 as u32));
        assert_eq!(quick.members(), 5000);
        assert_eq!(quick.after(100, Duration::from_secs(1)).members(), 25);
        assert_eq!(quick.after(0, Duration::from_secs(1)).members(), 1);
        assert_eq!(Pace::UNKNOWN.after(1, Duration::ZERO).members(), GROWTH);
    }
}
