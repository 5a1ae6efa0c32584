//! The series of a phase.

use super::{Expansion, Guards};
use crate::integrate::store::Store;
use crate::model::{Array, BarSystem, PhaseSeries, TermsOf};
use crate::series::{ORDERS, TaylorTape};

/// The equations of a closed form on Taylor series, with the guards of its contacts.
pub struct PhaseExpansion<'a, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> {
    constants: &'a M::Constants<f64>,
    tape: Store<Columns<M, Q, N>>,
    work: Store<Work<M, N>>,
    terms: usize,
    values: Values<M, N>,
}

/// A tape of this phase alone: columns that it does not use stay zero.
struct Columns<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize>(Q::Tape<f64>);

impl<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> Default for Columns<M, Q, N> {
    fn default() -> Self {
        Self(Q::Tape::default())
    }
}

/// What an expansion writes besides.
struct Work<M: BarSystem, const N: usize> {
    series: [[f64; N]; ORDERS],
    guards: [Guard<M>; ORDERS],
    scaled: Scaled<M>,
}

impl<M: BarSystem, const N: usize> Default for Work<M, N> {
    fn default() -> Self {
        let guards = core::array::from_fn(|_| Guard::default());
        Self { series: [[0.0; N]; ORDERS], guards, scaled: Scaled::default() }
    }
}

/// Order 0, which is on the tape.
struct Values<M: BarSystem, const N: usize> {
    /// Whether it is, at the state.
    known: bool,
    state: [f64; N],
    rates: [f64; N],
    guard: Guard<M>,
}

/// One coefficient of all guards.
struct Guard<M: BarSystem> {
    reactions: M::Reactions<f64>,
    gaps: M::Reactions<f64>,
    feet: M::Feet<f64>,
}

impl<M: BarSystem> Default for Guard<M> {
    fn default() -> Self {
        let (contacts, feet) = (Array::from_fn(|_| 0.0), Array::from_fn(|_| 0.0));
        Self { reactions: contacts, gaps: contacts, feet }
    }
}

/// Coefficients of an array's entries.
type Series<A> = <A as Array<f64>>::Of<[f64; ORDERS]>;

/// All coefficients of each guard, over the step.
struct Scaled<M: BarSystem> {
    reactions: Series<M::Reactions<f64>>,
    gaps: Series<M::Reactions<f64>>,
    feet: Series<M::Feet<f64>>,
}

impl<M: BarSystem> Default for Scaled<M> {
    fn default() -> Self {
        let (contacts, feet) = (Array::from_fn(|_| [0.0; ORDERS]), Array::from_fn(|_| [0.0; ORDERS]));
        Self { reactions: contacts, gaps: contacts, feet }
    }
}

impl<'a, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> PhaseExpansion<'a, M, Q, N> {
    /// The series of `Q` with these constants.
    pub fn new(constants: &'a M::Constants<f64>) -> Self {
        let mut work = Store::<Work<M, N>>::default();
        // Orders above the last are none: the one before may have had more.
        work.series = [[0.0; N]; ORDERS];
        Self {
            constants,
            tape: Store::default(),
            work,
            terms: 0,
            values: Values {
                known: false,
                state: [f64::NAN; N],
                rates: [f64::NAN; N],
                guard: Guard::default(),
            },
        }
    }

    #[inline(always)]
    fn take(guard: &mut Guard<M>, terms: TermsOf<M, f64, N>) -> [f64; N] {
        if !M::LAYOUT.contacts.is_empty() {
            *guard = Guard { reactions: terms.reactions, gaps: terms.gaps, feet: terms.feet };
        }
        terms.rates
    }

    /// Order 0 at a state, unless it is known.
    fn begin(&mut self, state: &[f64; N]) {
        let Self { constants, tape, values, .. } = self;
        if !values.known || values.state != *state {
            (values.known, values.state) = (true, *state);
            values.rates = Self::take(&mut values.guard, Q::order(constants, &mut tape.0.values(), state));
        }
    }
}

impl<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> Expansion<N> for PhaseExpansion<'_, M, Q, N> {
    fn expand(&mut self, state: &[f64; N], unit: f64, order: usize) {
        self.begin(state);
        let Self { constants, tape, work, terms, values } = self;
        let (Columns(tape), Work { series, guards, .. }) = (&mut **tape, &mut **work);
        series[0] = *state;
        *terms = if M::LAYOUT.contacts.is_empty() { 0 } else { order };
        let Guard { reactions, gaps, feet } = values.guard;
        guards[0] = Guard { reactions, gaps, feet };
        // Kept out of memory: an order need not wait for what the last one stores.
        let mut state = values.rates.map(|rate| unit * rate);
        series[1] = state;
        // The orders that follow write over some of it.
        values.known = false;
        for n in 1..order {
            let terms = Q::order(constants, &mut tape.coefficients(n), &state);
            let part = unit / (n + 1) as f64;
            state = Self::take(&mut guards[n], terms).map(|rate| part * rate);
            series[n + 1] = state;
        }
    }

    fn series(&self) -> &[[f64; N]; ORDERS] {
        &self.work.series
    }

    fn rates(&mut self, state: &[f64; N]) -> [f64; N] {
        self.begin(state);
        self.values.rates
    }

    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>> {
        let terms = self.terms;
        let Work { guards, scaled, .. } = &mut *self.work;
        let Scaled { reactions, gaps, feet } = scaled;
        let rows = &guards[..terms];
        let mut powers = [1.0; ORDERS];
        for k in 1..terms {
            powers[k] = ratio * powers[k - 1];
        }
        scale(reactions.as_mut(), &powers, rows, |guard, i| guard.reactions.as_ref()[i]);
        scale(gaps.as_mut(), &powers, rows, |guard, i| guard.gaps.as_ref()[i]);
        scale(feet.as_mut(), &powers, rows, |guard, i| guard.feet.as_ref()[i]);
        let Scaled { reactions, gaps, feet } = &*scaled;
        Some(Guards::new(terms, reactions.as_ref(), gaps.as_ref(), feet.as_ref()))
    }
}

/// Each series from its terms in `rows` times powers of the step; zero stays zero where those overflow.
#[inline(always)]
fn scale<G>(
    series: &mut [[f64; ORDERS]],
    powers: &[f64; ORDERS],
    rows: &[G],
    term: impl Fn(&G, usize) -> f64,
) {
    for (i, series) in series.iter_mut().enumerate() {
        for ((scaled, power), row) in series.iter_mut().zip(powers).zip(rows) {
            let term = term(row, i);
            *scaled = if term == 0.0 { 0.0 } else { power * term };
        }
    }
}
