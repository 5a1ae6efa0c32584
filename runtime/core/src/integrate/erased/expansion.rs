//! Taylor series of a phase of any dimension.

use crate::integrate::{Expansion, Guards, PhaseExpansion};
use crate::model::{BarSystem, PhaseSeries};
use crate::series::ORDERS;
use crate::system::to_array;

/// [`Expansion`] with its dimension forgotten.
pub trait SeriesExpansion {
    /// Expands y(t₀ + `unit` θ) = Σ cₖ θᵏ from c₀ = `state` up to k = `order` < [`ORDERS`].
    fn expand(&mut self, state: &[f64], unit: f64, order: usize);
    /// c₀, c₁, … one behind the other, [`ORDERS`] of them.
    fn series(&self) -> &[f64];
    /// f, with the series and the guards left as they are.
    fn rates(&mut self, state: &[f64], rates: &mut [f64]);
    /// The guards of the last expansion over 0 ≤ θ ≤ `ratio`, if it has any.
    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>>;
}

impl<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> SeriesExpansion for PhaseExpansion<'_, M, Q, N> {
    fn expand(&mut self, state: &[f64], unit: f64, order: usize) {
        Expansion::expand(self, &to_array(state), unit, order);
    }

    fn series(&self) -> &[f64] {
        Expansion::series(self).as_flattened()
    }

    fn rates(&mut self, state: &[f64], rates: &mut [f64]) {
        rates.copy_from_slice(&Expansion::rates(self, &to_array(state)));
    }

    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>> {
        Expansion::guards(self, ratio)
    }
}

/// A source of series filled up with entries that stand still.
pub(super) struct Padded<'a, const N: usize> {
    inner: Box<dyn SeriesExpansion + 'a>,
    entries: usize,
    /// Filled up, where they are fewer than the capacity.
    series: Option<Box<[[f64; N]; ORDERS]>>,
}

impl<'a, const N: usize> Padded<'a, N> {
    pub(super) fn of(inner: Box<dyn SeriesExpansion + 'a>, entries: usize) -> Self {
        let series = (inner.series().len() < N * ORDERS).then(|| Box::new([[0.0; N]; ORDERS]));
        Self { inner, entries, series }
    }
}

impl<const N: usize> Expansion<N> for Padded<'_, N> {
    fn expand(&mut self, state: &[f64; N], unit: f64, order: usize) {
        self.inner.expand(&state[..self.entries], unit, order);
        if let Some(series) = &mut self.series {
            for (wide, narrow) in series.iter_mut().zip(self.inner.series().chunks_exact(self.entries.max(1)))
            {
                wide[..self.entries].copy_from_slice(narrow);
            }
        }
    }

    fn series(&self) -> &[[f64; N]; ORDERS] {
        match &self.series {
            Some(series) => series,
            None => self.inner.series().as_chunks().0.first_chunk().expect("no fewer than the capacity"),
        }
    }

    fn rates(&mut self, state: &[f64; N]) -> [f64; N] {
        let mut rates = [0.0; N];
        self.inner.rates(&state[..self.entries], &mut rates[..self.entries]);
        rates
    }

    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>> {
        self.inner.guards(ratio)
    }
}
