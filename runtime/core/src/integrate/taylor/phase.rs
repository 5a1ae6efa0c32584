//! The series of a phase.

use core::ops::Deref;

use super::{Expansion, Guards};
use crate::integrate::store::Store;
use crate::model::{Array, BarSystem, PhaseSeries, TermsOf};
use crate::scalar::{Double, Inside};
use crate::series::{ORDERS, TaylorTape};

/// The equations of a closed form on Taylor series, with the guards of its contacts, by doubles
/// `S`, whose constants are `C`.
pub struct ExpansionBy<C, S: Double, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> {
    constants: C,
    tape: Store<Columns<S, M, Q, N>>,
    work: Store<Work<M, N>>,
    terms: usize,
    values: Values<M, N>,
}

/// The same by the doubles of the target.
pub type PhaseExpansion<'a, M, Q, const N: usize> =
    ExpansionBy<&'a <M as BarSystem>::Constants<f64>, f64, M, Q, N>;

/// A tape of this phase alone: columns that it does not use stay zero.
struct Columns<S: Double, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize>(Q::Tape<S>);

impl<S: Double, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> Default for Columns<S, M, Q, N> {
    fn default() -> Self {
        Self(Q::Tape::default())
    }
}

/// What an expansion writes besides.
struct Work<M: BarSystem, const N: usize> {
    series: [[f64; N]; ORDERS],
    guards: GuardSeries<M>,
    /// The same over the step.
    scaled: GuardSeries<M>,
}

impl<M: BarSystem, const N: usize> Default for Work<M, N> {
    fn default() -> Self {
        Self { series: [[0.0; N]; ORDERS], guards: GuardSeries::default(), scaled: GuardSeries::default() }
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

/// All coefficients of each guard.
struct GuardSeries<M: BarSystem> {
    reactions: Series<M::Reactions<f64>>,
    gaps: Series<M::Reactions<f64>>,
    feet: Series<M::Feet<f64>>,
}

impl<M: BarSystem> Default for GuardSeries<M> {
    fn default() -> Self {
        let (contacts, feet) = (Array::from_fn(|_| [0.0; ORDERS]), Array::from_fn(|_| [0.0; ORDERS]));
        Self { reactions: contacts, gaps: contacts, feet }
    }
}

impl<M: BarSystem> GuardSeries<M> {
    #[inline(always)]
    fn set(&mut self, order: usize, guard: &Guard<M>) {
        let write = |series: &mut [[f64; ORDERS]], terms: &[f64]| {
            series.iter_mut().zip(terms).for_each(|(series, term)| series[order] = *term);
        };
        write(self.reactions.as_mut(), guard.reactions.as_ref());
        write(self.gaps.as_mut(), guard.gaps.as_ref());
        write(self.feet.as_mut(), guard.feet.as_ref());
    }
}

impl<C, S, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> ExpansionBy<C, S, M, Q, N>
where
    C: Deref<Target = M::Constants<S>>,
    S: Double,
{
    /// The series of `Q` with these constants.
    pub fn new(constants: C) -> Self {
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
    fn apart(terms: &TermsOf<M, S, N>) -> ([f64; N], Guard<M>) {
        let mut rates = [0.0; N];
        for i in 0..N {
            rates[i] = terms.rates[i].value();
        }
        let mut guard = Guard::<M>::default();
        write_values(guard.reactions.as_mut(), terms.reactions.as_ref());
        write_values(guard.gaps.as_mut(), terms.gaps.as_ref());
        write_values(guard.feet.as_mut(), terms.feet.as_ref());
        (rates, guard)
    }

    /// Order 0 at a state, unless it is known.
    fn begin(&mut self, state: &[f64; N]) {
        if !self.values.known || self.values.state != *state {
            S::inside(Begin(self, state));
        }
    }
}

#[inline(always)]
fn numbers<S: Double, const N: usize>(values: &[f64; N]) -> [S; N] {
    let mut numbers = [S::ratio(0, 1); N];
    for i in 0..N {
        numbers[i] = S::from_f64(values[i]);
    }
    numbers
}

#[inline(always)]
fn write_values<S: Double>(values: &mut [f64], numbers: &[S]) {
    for (value, number) in values.iter_mut().zip(numbers) {
        *value = number.value();
    }
}

/// Order 0 at a state.
struct Begin<'a, E, const N: usize>(&'a mut E, &'a [f64; N]);

impl<C, S, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> Inside
    for Begin<'_, ExpansionBy<C, S, M, Q, N>, N>
where
    C: Deref<Target = M::Constants<S>>,
    S: Double,
{
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let ExpansionBy { constants, tape, values, .. } = self.0;
        (values.known, values.state) = (true, *self.1);
        let terms = Q::order(&**constants, &mut tape.0.values(), &numbers(self.1));
        (values.rates, values.guard) = ExpansionBy::<C, S, M, Q, N>::apart(&terms);
    }
}

/// The orders above, in a unit.
struct Expand<'a, E, const N: usize> {
    of: &'a mut E,
    state: &'a [f64; N],
    unit: f64,
    order: usize,
}

impl<C, S, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> Inside
    for Expand<'_, ExpansionBy<C, S, M, Q, N>, N>
where
    C: Deref<Target = M::Constants<S>>,
    S: Double,
{
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { of, state, unit, order } = self;
        let ExpansionBy { constants, tape, work, terms, values } = of;
        let (Columns(tape), Work { series, guards, .. }) = (&mut **tape, &mut **work);
        series[0] = *state;
        *terms = if M::LAYOUT.contacts.is_empty() { 0 } else { order };
        guards.set(0, &values.guard);
        // Kept out of memory: an order need not wait for what the last one stores.
        let mut state = values.rates;
        for i in 0..N {
            state[i] *= unit;
        }
        series[1] = state;
        // The orders that follow write over some of it.
        values.known = false;
        for n in 1..order {
            let terms = Q::order(&**constants, &mut tape.coefficients(n), &numbers(&state));
            let (rates, guard) = ExpansionBy::<C, S, M, Q, N>::apart(&terms);
            let part = unit / (n + 1) as f64;
            for i in 0..N {
                state[i] = part * rates[i];
            }
            series[n + 1] = state;
            guards.set(n, &guard);
        }
    }
}

impl<C, S, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> Expansion<N> for ExpansionBy<C, S, M, Q, N>
where
    C: Deref<Target = M::Constants<S>>,
    S: Double,
{
    fn expand(&mut self, state: &[f64; N], unit: f64, order: usize) {
        self.begin(state);
        S::inside(Expand { of: self, state, unit, order });
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
        let mut powers = [1.0; ORDERS];
        for k in 1..terms {
            powers[k] = ratio * powers[k - 1];
        }
        scale(scaled.reactions.as_mut(), (&powers, terms), guards.reactions.as_ref());
        scale(scaled.gaps.as_mut(), (&powers, terms), guards.gaps.as_ref());
        scale(scaled.feet.as_mut(), (&powers, terms), guards.feet.as_ref());
        Some(Guards::new(terms, scaled.reactions.as_ref(), scaled.gaps.as_ref(), scaled.feet.as_ref()))
    }
}

/// The first terms of each series times powers of the step, four at once; zero stays zero where
/// those overflow.
#[inline(always)]
fn scale(scaled: &mut [[f64; ORDERS]], (powers, terms): (&[f64; ORDERS], usize), series: &[[f64; ORDERS]]) {
    let (powers, fours) = (powers.as_chunks::<4>().0, terms.div_ceil(4).min(ORDERS / 4));
    for (scaled, series) in scaled.iter_mut().zip(series) {
        let (scaled, series) = (scaled.as_chunks_mut::<4>().0, series.as_chunks::<4>().0);
        for k in 0..fours {
            let (terms, powers) = (&series[k], &powers[k]);
            scaled[k] = core::array::from_fn(|i| if terms[i] == 0.0 { 0.0 } else { powers[i] * terms[i] });
        }
    }
}
