//! Taylor coefficients of any field by jets, one order after the other.

use super::fields::Field;
use crate::integrate::{Expansion, Guards};
use crate::scalar::Jet;
use crate::series::ORDERS;

/// A field as a source of Taylor coefficients.
pub(in crate::integrate) struct Jets<'a, F>(pub(in crate::integrate) &'a F);

impl<F: Field<N>, const N: usize> Expansion<N> for Jets<'_, F> {
    fn expand(&mut self, unit: f64, order: usize, series: &mut [[f64; N]; ORDERS]) {
        for n in 0..order {
            let known = |i: usize, k: usize| if k <= n { series[k][i] } else { 0.0 };
            let jets =
                core::array::from_fn(|i| Jet::<f64, ORDERS>::new(core::array::from_fn(|k| known(i, k))));
            let rates = self.0.rates(&jets);
            series[n + 1] = rates.map(|rate| rate.coefficient(n) * unit / (n + 1) as f64);
        }
    }

    fn guards(&mut self, _: f64) -> Option<Guards<'_>> {
        None
    }
}
