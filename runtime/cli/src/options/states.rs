//! States at requested times, taken while a run goes on, so that the motion need not be kept.

use liftoff::{Observer, Step, Trajectory};

/// States at requested times.
pub struct States {
    /// In order.
    at: std::vec::IntoIter<f64>,
    every: Option<f64>,
    multiples: u64,
    most: usize,
    samples: Vec<(f64, Vec<f64>)>,
}

impl States {
    /// At these times and at every multiple of a time; no more than `most` of them.
    pub fn new(mut at: Vec<f64>, every: Option<f64>, most: usize) -> Self {
        at.sort_by(f64::total_cmp);
        Self { at: at.into_iter(), every, multiples: 0, most, samples: Vec::new() }
    }

    /// The next time, which stays the next.
    fn next(&self) -> Option<f64> {
        let multiple = self.every.map(|every| self.multiples as f64 * every);
        let given = self.at.as_slice().first().copied();
        given.into_iter().chain(multiple).reduce(f64::min).filter(|_| self.samples.len() <= self.most)
    }

    fn take(&mut self, t: f64, state: Vec<f64>) {
        self.samples.push((t, state));
        if self.at.as_slice().first().is_some_and(|first| *first <= t) {
            self.at.next();
        } else {
            self.multiples += 1;
        }
    }

    /// All of a run that has ended.
    pub fn of(mut self, record: &Trajectory) -> Vec<(f64, Vec<f64>)> {
        while let Some(t) = self.next().filter(|t| *t <= record.end_time()) {
            self.take(t, record.final_state());
        }
        self.samples
    }
}

impl Observer for States {
    /// At the end of a step the next one, behind an event perhaps, has the state.
    fn step(&mut self, step: &dyn Step) {
        let [_, end] = step.times();
        while let Some(t) = self.next().filter(|t| *t < end) {
            self.take(t, step.state(t));
        }
    }
}
