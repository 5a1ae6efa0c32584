//! Times of a run.

use core::time::Duration;
use std::time::Instant;

/// So many runs for a median, if they take less than ten times as long as asked.
const FEWEST: usize = 3;
/// And at most: the least time of more is no smaller.
const MOST: usize = 2000;

/// Times of several runs, s.
pub(super) struct Times {
    pub(super) median: f64,
    pub(super) least: f64,
}

/// Runs again and again for about this long.
pub(super) fn measure(time: Duration, mut run: impl FnMut()) -> Times {
    let begun = Instant::now();
    let mut times = Vec::new();
    let more = |done: usize| match begun.elapsed() {
        spent if done < FEWEST => done == 0 || spent < 10 * time,
        spent => spent < time && done < MOST,
    };
    while more(times.len()) {
        let start = Instant::now();
        run();
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    Times { median: times[times.len() / 2], least: times[0] }
}
