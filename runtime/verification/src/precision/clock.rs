//! Times of runs, taken in rounds.

use core::time::Duration;
use std::time::Instant;

/// Rounds in which everything is timed in turn, so that what else the machine does falls on all
/// alike.
pub const ROUNDS: u32 = 8;
/// What has taken so many times the time asked for has no further round.
const LONG: u32 = 10;
/// Runs of a round at most: the least time of more is no smaller.
const MOST: usize = 250;

/// Times of several runs, s.
#[derive(Default)]
pub(super) struct Times(Vec<f64>);

impl Times {
    /// One run at least, and as many as its part of the time allows.
    pub(super) fn add_round(&mut self, time: Duration, mut run: impl FnMut()) {
        let spent: f64 = self.0.iter().sum();
        if !self.0.is_empty() && spent >= (LONG * time).as_secs_f64() {
            return;
        }
        let begun = Instant::now();
        for _ in 0..MOST {
            let start = Instant::now();
            run();
            self.0.push(start.elapsed().as_secs_f64());
            if begun.elapsed() >= time / ROUNDS {
                break;
            }
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Median and least.
    pub(super) fn summarize(mut self) -> [f64; 2] {
        self.0.sort_by(f64::total_cmp);
        [self.0.get(self.0.len() / 2), self.0.first()].map(|time| time.copied().unwrap_or(f64::NAN))
    }
}
