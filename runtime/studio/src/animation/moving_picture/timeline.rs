//! When a time of the run is on the screen.

use liftoff::Trajectory;

/// Seconds that a run may take on the screen as they are; longer and shorter ones take about
/// `WISHED`.
const AS_IT_IS: [f64; 2] = [3.0, 10.0];
const WISHED: f64 = 6.0;

/// Seconds that the end stays on the screen before all begins again.
const RESTING: f64 = 2.0;

/// The times that are drawn, and when.
pub(super) struct Timeline {
    /// Times of the run in order; where a phase ends and the next begins, the last before and the
    /// first after.
    pub times: Vec<f64>,
    interval: [f64; 2],
    /// Time of the run over time on the screen.
    pub pace: f64,
    /// Seconds that the end stays on the screen.
    resting: f64,
}

impl Timeline {
    /// About so many times of a run, so many times slower than it is; as people can follow it if
    /// none is given.
    pub fn new(record: &Trajectory, frames: usize, slower: Option<f64>) -> Self {
        let [start, end] = record.interval();
        let length = end - start;
        let step = length / frames as f64;
        let mut times: Vec<f64> = (0..=frames).map(|i| start + step * i as f64).collect();
        times[frames] = end;
        let mut last = start;
        for phase in record.segments() {
            let jump = phase.t0;
            if jump - last > 0.5 * step && end - jump > 0.5 * step {
                times.extend([jump.next_down(), jump]);
                last = jump;
            }
        }
        times.sort_by(f64::total_cmp);
        times.dedup();
        let pace = slower.map_or_else(|| pace(length), f64::recip);
        Self { times, interval: [start, end], pace, resting: RESTING }
    }

    /// So many times of a cycle of so many seconds, which begins again where it ends.
    pub fn cycle(frames: usize, length: f64) -> Self {
        let times = (0..=frames).map(|i| length * i as f64 / frames as f64).collect();
        Self { times, interval: [0.0, length], pace: 1.0, resting: 0.0 }
    }

    /// Seconds from one beginning to the next.
    pub fn period(&self) -> f64 {
        self.playing() + self.resting
    }

    fn playing(&self) -> f64 {
        (self.interval[1] - self.interval[0]) / self.pace
    }

    /// When a time is on the screen, as a part of the period.
    pub fn key(&self, t: f64) -> f64 {
        ((t - self.interval[0]) / self.pace / self.period()).clamp(0.0, 1.0)
    }

    /// When the end is.
    pub fn end(&self) -> f64 {
        self.playing() / self.period()
    }

    /// The index of the last time that is drawn at or before this one.
    pub fn frame(&self, t: f64) -> usize {
        self.times.partition_point(|&time| time <= t).saturating_sub(1)
    }
}

/// A factor that people can imagine: 1, or 1, 2 or 5 times a power of ten.
fn pace(length: f64) -> f64 {
    if (AS_IT_IS[0]..=AS_IT_IS[1]).contains(&length) || length <= 0.0 {
        return 1.0;
    }
    let power = 10.0_f64.powf((length / WISHED).log10().floor());
    let wrong = |pace: f64| (length / pace / WISHED).ln().abs();
    let round = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power);
    round.into_iter().fold(power, |best, pace| if wrong(pace) < wrong(best) { pace } else { best })
}

#[cfg(test)]
mod tests {
    use super::pace;

    #[test]
    fn runs_take_some_seconds() {
        assert_eq!([5.0, 1.5, 0.03, 100.0, 0.0].map(pace), [1.0, 0.2, 0.005, 20.0, 1.0]);
    }
}
