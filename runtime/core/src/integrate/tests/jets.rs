//! Taylor coefficients of any vector field by jets, one order after the other.

use super::fields::Field;
use crate::integrate::{Expansion, Guards};
use crate::scalar::Jet;
use crate::series::ORDERS;

/// A field as a source of Taylor coefficients.
pub(in crate::integrate) struct Jets<'a, F, const N: usize> {
    field: &'a F,
    series: [[f64; N]; ORDERS],
}

impl<'a, F: Field<N>, const N: usize> Jets<'a, F, N> {
    pub(in crate::integrate) fn new(field: &'a F) -> Self {
        Self { field, series: [[0.0; N]; ORDERS] }
    }
}

impl<F: Field<N>, const N: usize> Expansion<N> for Jets<'_, F, N> {
    fn expand(&mut self, state: &[f64; N], unit: f64, order: usize) {
        let series = &mut self.series;
        series[0] = *state;
        for n in 0..order {
            let known = |i: usize, k: usize| if k <= n { series[k][i] } else { 0.0 };
            let jets =
                core::array::from_fn(|i| Jet::<f64, ORDERS>::new(core::array::from_fn(|k| known(i, k))));
            let rates = self.field.rates(&jets);
            series[n + 1] = rates.map(|rate| rate.coefficient(n) * unit / (n + 1) as f64);
        }
    }

    fn series(&self) -> &[[f64; N]; ORDERS] {
        &self.series
    }

    fn rates(&mut self, state: &[f64; N]) -> [f64; N] {
        self.field.rates(state)
    }

    fn guards(&mut self, _: f64) -> Option<Guards<'_>> {
        None
    }
}
