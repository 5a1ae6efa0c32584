//! Times at which a motion is looked at.

/// Rows between the ends of a run, at least; a coarser grid is taken once there would be twice as many, or five times.
const ROWS: f64 = 1000.0;

/// Times at which a motion is looked at, in order.
pub enum Clock {
    Given(Given),
    Even(Even),
}

/// Times that are asked for.
pub struct Given {
    at: std::vec::IntoIter<f64>,
    every: Option<f64>,
    multiples: u64,
    left: usize,
}

/// Multiples of a time, 1 or 2 times a power of ten, that grows with the run: of a run of unknown length some thousand.
#[derive(Default)]
pub struct Even {
    /// When the run begins.
    begin: f64,
    grid: Option<Grid>,
    multiples: u64,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Grid {
    mantissa: u64,
    exponent: i32,
}

impl Clock {
    /// These times and every multiple of a time, no more than `most` of them.
    pub fn given(mut at: Vec<f64>, every: Option<f64>, most: usize) -> Self {
        at.sort_by(f64::total_cmp);
        Self::Given(Given { at: at.into_iter(), every, multiples: 0, left: most })
    }

    /// The next time.
    pub fn next(&self) -> Option<f64> {
        match self {
            Self::Given(given) => given.next(),
            Self::Even(even) => even.grid.map(|grid| even.begin + grid.time(even.multiples)),
        }
    }

    /// The place of the next time among multiples.
    pub fn next_index(&self) -> u64 {
        match self {
            Self::Given(Given { multiples, .. }) | Self::Even(Even { multiples, .. }) => *multiples,
        }
    }

    /// Leaves out the times before a run begins; what grows with the run grows from there.
    pub fn begin(&mut self, t: f64) {
        match self {
            Self::Given(given) => given.begin(t),
            Self::Even(even) => even.begin = t,
        }
    }

    /// Goes on behind a time.
    pub fn pass(&mut self, t: f64) {
        match self {
            Self::Given(given) => given.pass(t),
            Self::Even(even) => {
                let next = even.grid.map(|grid| even.begin + grid.time(even.multiples));
                even.multiples += u64::from(next.is_some_and(|next| next <= t));
            }
        }
    }

    /// Takes note that the run is as long as this; of the times so far every so many-th is to be kept.
    pub fn reach(&mut self, t: f64) -> u64 {
        if let Self::Even(even) = self { even.reach(t - even.begin) } else { 1 }
    }
}

impl Given {
    fn begin(&mut self, t: f64) {
        while self.at.as_slice().first().is_some_and(|first| *first < t) {
            self.at.next();
        }
        let multiples = self.every.map_or(0.0, |every| (t / every).ceil());
        self.multiples = self.multiples.max(multiples as u64);
    }

    fn next(&self) -> Option<f64> {
        let multiple = self.every.map(|every| self.multiples as f64 * every);
        let given = self.at.as_slice().first().copied();
        given.into_iter().chain(multiple).reduce(f64::min).filter(|_| self.left > 0)
    }

    fn pass(&mut self, t: f64) {
        self.left -= 1;
        while self.at.as_slice().first().is_some_and(|first| *first <= t) {
            self.at.next();
        }
        if self.every.is_some_and(|every| self.multiples as f64 * every <= t) {
            self.multiples += 1;
        }
    }
}

impl Even {
    fn reach(&mut self, t: f64) -> u64 {
        if t.is_nan() || t <= 0.0 {
            return 1;
        }
        let mut every = 1;
        let mut grid = *self.grid.get_or_insert_with(|| Grid::for_run(t));
        while let Some((coarser, times)) = grid.coarser(t) {
            (grid, every) = (coarser, every * times);
        }
        self.grid = Some(grid);
        self.multiples = self.multiples.div_ceil(every);
        every
    }
}

impl Grid {
    fn for_run(t: f64) -> Self {
        Self { mantissa: 1, exponent: (t / ROWS).log10().floor() as i32 }
    }

    fn time(self, multiples: u64) -> f64 {
        let count = (multiples * self.mantissa) as f64;
        // Powers of ten are exact where they are whole, and so the quotient is the nearest number to the decimal.
        let power = 10f64.powi(self.exponent.abs());
        if self.exponent < 0 { count / power } else { count * power }
    }

    /// The next coarser grid, and how many times so, if this one has too many rows.
    fn coarser(self, t: f64) -> Option<(Self, u64)> {
        let (coarser, times) = match self.mantissa {
            1 => (Self { mantissa: 2, ..self }, 2),
            _ => (Self { mantissa: 1, exponent: self.exponent + 1 }, 5),
        };
        (t / self.time(1) >= times as f64 * ROWS).then_some((coarser, times))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// However long the run and its steps, the rows are multiples of a round time, at least a thousand.
    #[test]
    fn a_growing_run_keeps_some_thousand_rows_at_round_times() {
        for (end, steps) in [(1e-7, 3), (0.37, 10), (10.0, 4000), (1e5, 70_000)] {
            let mut clock = Clock::Even(Even::default());
            let mut rows: Vec<(u64, f64)> = Vec::new();
            for step in 1..=steps {
                let t = end * f64::from(step) / f64::from(steps);
                let every = clock.reach(t);
                rows.retain(|(place, _)| place % every == 0);
                rows.iter_mut().for_each(|(place, _)| *place /= every);
                while let Some(next) = clock.next().filter(|next| *next < t) {
                    rows.push((clock.next_index(), next));
                    clock.pass(next);
                }
                assert!(rows.len() <= 5000);
            }
            assert!((1000..=5000).contains(&rows.len()), "{end}: {}", rows.len());
            let dt = rows[1].1;
            assert!(rows.iter().enumerate().all(|(k, (place, t))| {
                *place == k as u64 && (t - k as f64 * dt).abs() <= 1e-15 * t.abs()
            }));
            assert!(format!("{dt:e}").starts_with(['1', '2']), "{dt}");
        }
    }

    #[test]
    fn given_times_and_multiples_come_in_order_and_once() {
        let mut clock = Clock::given(vec![2.0, 0.5, 1.0, 0.5], Some(1.0), 5);
        let mut times = Vec::new();
        while let Some(t) = clock.next() {
            times.push(t);
            clock.pass(t);
        }
        assert_eq!(times, [0.0, 0.5, 1.0, 2.0, 3.0]);
        let after = |mut clock: Clock, begin: f64| {
            clock.begin(begin);
            clock.reach(begin + 1.0);
            let first = clock.next().unwrap();
            clock.pass(first);
            [first, clock.next().unwrap()]
        };
        assert_eq!(after(Clock::given(vec![2.5, 0.5], Some(1.0), 5), 1.5), [2.0, 2.5]);
        for begin in [0.1, 1e6] {
            assert_eq!(after(Clock::Even(Even::default()), begin), [begin, begin + 1e-3]);
        }
    }
}
