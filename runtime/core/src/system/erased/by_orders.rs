//! Taylor series of what gives one order after the other, its dimensions known when it is made.

use super::SeriesExpansion;
use crate::integrate::Guards;
use crate::series::ORDERS;

/// Equations of a phase on Taylor series.
pub trait SeriesOrders {
    /// Order n of everything from that of the state, once those below have been computed: of the
    /// rates; then of the reactions, the gaps and the distances of the feet, one behind the other.
    fn order(&mut self, n: usize, state: &[f64], rates: &mut [f64], guard: &mut [f64]);
}

/// A source of Taylor coefficients; it keeps those of the last expansion.
pub struct ByOrders<O> {
    orders: O,
    /// How many reactions there are, and gaps.
    reactions: usize,
    /// c₀, c₁, …, one after the other.
    series: Vec<f64>,
    /// One coefficient of all guards after the other.
    guards: Vec<f64>,
    scaled: Vec<[f64; ORDERS]>,
    terms: usize,
    values: Values,
}

/// Order 0.
struct Values {
    /// Whether it is that of the state.
    known: bool,
    state: Vec<f64>,
    rates: Vec<f64>,
    guard: Vec<f64>,
}

impl<O: SeriesOrders> ByOrders<O> {
    /// Of states of so many entries, with so many reactions, as many gaps, and so many distances.
    pub fn new(orders: O, entries: usize, [reactions, distances]: [usize; 2]) -> Self {
        let width = 2 * reactions + distances;
        Self {
            orders,
            reactions,
            series: vec![0.0; entries * ORDERS],
            guards: vec![0.0; width * ORDERS],
            scaled: vec![[0.0; ORDERS]; width],
            terms: 0,
            values: Values {
                known: false,
                state: vec![f64::NAN; entries],
                rates: vec![f64::NAN; entries],
                guard: vec![0.0; width],
            },
        }
    }

    /// Order 0 at a state, unless it is known.
    fn begin(&mut self, state: &[f64]) {
        let Self { orders, values, .. } = self;
        if !values.known || values.state != state {
            orders.order(0, state, &mut values.rates, &mut values.guard);
            values.known = true;
            values.state.copy_from_slice(state);
        }
    }
}

impl<O: SeriesOrders> SeriesExpansion for ByOrders<O> {
    fn expand(&mut self, state: &[f64], unit: f64, order: usize) {
        self.begin(state);
        let Self { orders, series, guards, terms, values, .. } = self;
        let (entries, width) = (state.len(), values.guard.len());
        *terms = if width == 0 { 0 } else { order };
        series[..entries].copy_from_slice(state);
        guards[..width].copy_from_slice(&values.guard);
        for (next, rate) in series[entries..].iter_mut().zip(&values.rates) {
            *next = unit * rate;
        }
        // The orders that follow write over some of it.
        values.known = false;
        for n in 1..order {
            let (below, above) = series.split_at_mut((n + 1) * entries);
            let rates = &mut above[..entries];
            orders.order(n, &below[n * entries..], rates, &mut guards[n * width..][..width]);
            let part = unit / (n + 1) as f64;
            rates.iter_mut().for_each(|rate| *rate *= part);
        }
    }

    fn series(&self) -> &[f64] {
        &self.series
    }

    fn rates(&mut self, state: &[f64], rates: &mut [f64]) {
        self.begin(state);
        rates.copy_from_slice(&self.values.rates);
    }

    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>> {
        let width = self.scaled.len();
        let mut power = 1.0;
        for (k, row) in self.guards.chunks_exact(width.max(1)).take(self.terms).enumerate() {
            for (series, term) in self.scaled.iter_mut().zip(row) {
                series[k] = if *term == 0.0 { 0.0 } else { power * term };
            }
            power *= ratio;
        }
        let (reactions, rest) = self.scaled.split_at(self.reactions);
        let (gaps, feet) = rest.split_at(self.reactions);
        Some(Guards::new(self.terms, reactions, gaps, feet))
    }
}
