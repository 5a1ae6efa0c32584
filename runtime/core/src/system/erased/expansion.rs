//! Taylor series of a phase of any dimension.

use core::ops::Deref;

use super::InitialValueProblem;
use crate::integrate::{Expansion, ExpansionBy, Guards};
use crate::model::{BarSystem, Form, PhaseSeries};
use crate::scalar::Double;
use crate::series::ORDERS;
use crate::system::arrays::to_array;

/// [`Expansion`] with its dimension forgotten.
pub trait SeriesExpansion {
    /// Expands y(t₀ + `unit` θ) = Σ cₖ θᵏ from c₀ = `state` up to k = `order` < [`ORDERS`].
    fn expand(&mut self, state: &[f64], unit: f64, order: usize);
    /// c₀, c₁, … one behind the other, [`ORDERS`] of them.
    fn series(&self) -> &[f64];
    /// Writes f; the series and the guards are left as they are. An expansion at the same state
    /// that follows has its values already.
    fn rates(&mut self, state: &[f64], rates: &mut [f64]);
    /// The guards of the last expansion over 0 ≤ θ ≤ `ratio`, if it has any.
    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>>;
}

impl<C, S, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> SeriesExpansion for ExpansionBy<C, S, M, Q, N>
where
    C: Deref<Target = M::Constants<S>>,
    S: Double,
{
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

/// The series of a phase, filled up with entries that stand still.
pub(super) struct Padded<'a, const N: usize> {
    inner: Box<dyn SeriesExpansion + 'a>,
    problem: InitialValueProblem<'a>,
    /// Filled up, [`ORDERS`] rows, where they are fewer than the capacity; else none.
    filled: Vec<[f64; N]>,
}

impl<'a, const N: usize> Padded<'a, N> {
    /// None where the phase has no series.
    pub(super) fn from_problem(problem: &InitialValueProblem<'a>) -> Option<Self> {
        let mut inner = problem.phase.series()?;
        if problem.phase.info().form == Form::Multipliers {
            let mut rates = vec![0.0; problem.len()];
            inner.rates(problem.start, &mut rates);
            // Rows that repeat each other leave no factors.
            rates.iter().all(|rate| rate.is_finite()).then_some(())?;
        }
        let rows = if inner.series().len() < N * ORDERS { ORDERS } else { 0 };
        Some(Self { inner, problem: *problem, filled: vec![[0.0; N]; rows] })
    }
}

impl<const N: usize> Expansion<N> for Padded<'_, N> {
    fn expand(&mut self, state: &[f64; N], unit: f64, order: usize) {
        let entries = self.problem.len();
        self.inner.expand(&state[..entries], unit, order);
        let series = self.inner.series().chunks_exact(entries.max(1));
        for (wide, narrow) in self.filled.iter_mut().zip(series) {
            wide[..entries].copy_from_slice(narrow);
        }
    }

    fn series(&self) -> &[[f64; N]; ORDERS] {
        let exact = || self.inner.series().as_chunks().0.first_chunk();
        self.filled.first_chunk().or_else(exact).expect("filled up where there are fewer")
    }

    fn rates(&mut self, state: &[f64; N]) -> [f64; N] {
        let (entries, mut rates) = (self.problem.len(), [0.0; N]);
        self.inner.rates(&state[..entries], &mut rates[..entries]);
        rates
    }

    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>> {
        self.inner.guards(ratio)
    }
}
