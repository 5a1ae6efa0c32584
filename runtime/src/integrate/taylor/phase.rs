//! The series of a phase.

use core::marker::PhantomData;

use super::{Expansion, Guards};
use crate::model::{Array, BarSystem, PhaseSeries, TermsOf};
use crate::series::{ORDERS, Record};

/// The equations of a closed form on Taylor series, with the guards of its contacts.
pub struct PhaseExpansion<'a, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> {
    constants: &'a M::Constants<f64>,
    tape: Box<Q::Tape<f64>>,
    guards: Vec<Guard<M>>,
    scaled: [Vec<f64>; 3],
    phase: PhantomData<Q>,
}

/// One coefficient of all guards.
struct Guard<M: BarSystem> {
    reactions: M::Reactions<f64>,
    gaps: M::Reactions<f64>,
    feet: M::Feet<f64>,
}

impl<'a, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> PhaseExpansion<'a, M, Q, N> {
    /// The series of `Q` with these constants.
    pub fn new(constants: &'a M::Constants<f64>) -> Self {
        let contacts = ORDERS * M::LAYOUT.contacts.len();
        let feet = ORDERS * M::Feet::<f64>::from_fn(|_| 0.0).as_ref().len();
        let scaled = [contacts, contacts, feet].map(|len| vec![0.0; len]);
        let guards = Vec::with_capacity(ORDERS);
        Self { constants, tape: Box::new(Q::Tape::<f64>::new()), guards, scaled, phase: PhantomData }
    }

    #[inline(always)]
    fn take(guards: &mut Vec<Guard<M>>, terms: TermsOf<M, f64, N>) -> [f64; N] {
        if !M::LAYOUT.contacts.is_empty() {
            guards.push(Guard { reactions: terms.reactions, gaps: terms.gaps, feet: terms.feet });
        }
        terms.rates
    }
}

impl<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> Expansion<N> for PhaseExpansion<'_, M, Q, N> {
    fn expand(&mut self, unit: f64, order: usize, series: &mut [[f64; N]; ORDERS]) {
        let Self { constants, tape, guards, .. } = self;
        guards.clear();
        let rates = Self::take(guards, Q::order(constants, &mut tape.values(), &series[0]));
        // Kept out of memory: an order need not wait for what the last one stores.
        let mut state = rates.map(|rate| unit * rate);
        series[1] = state;
        for n in 1..order {
            let terms = Q::order(constants, &mut tape.coefficients(n), &state);
            let part = unit / (n + 1) as f64;
            state = Self::take(guards, terms).map(|rate| part * rate);
            series[n + 1] = state;
        }
    }

    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>> {
        let terms = self.guards.len();
        let [reactions, gaps, feet] = &mut self.scaled;
        let mut power = 1.0;
        for (k, guard) in self.guards.iter().enumerate() {
            scale(reactions, (k, terms), guard.reactions.as_ref(), power);
            scale(gaps, (k, terms), guard.gaps.as_ref(), power);
            scale(feet, (k, terms), guard.feet.as_ref(), power);
            power *= ratio;
        }
        Some(Guards { terms, reactions, gaps, feet })
    }
}

/// Term k of each series times a power of the step; zero stays zero where that overflows.
fn scale(series: &mut [f64], (k, terms): (usize, usize), values: &[f64], power: f64) {
    for (i, value) in values.iter().enumerate() {
        series[i * terms + k] = if *value == 0.0 { 0.0 } else { power * value };
    }
}
