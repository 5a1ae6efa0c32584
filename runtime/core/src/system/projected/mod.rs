//! The Taylor series of a phase that keeps all coordinates, order by order: with K = [M −Jᵀ; J 0] over the closed rows,
//! x = (a, λ) and r = (f, −b),
//!
//! ```text
//! K₀ xₙ = rₙ − Σ Kₖ xₙ₋ₖ over 0 < k ≤ n
//! ```
//!
//! so that K is factorised once a step (the system of derivatives of index-reduced equations, as N. S. Nedialkov and J. D. Pryce,
//! *Solving differential-algebraic equations by Taylor series (I)*, BIT 45, 2005, solve it).

mod factors;
mod linear;

use crate::integrate::{Guards, SeriesExpansion};
use crate::model::{ContactSet, KernelView, Layout, Varying};
use crate::series::ORDERS;
use linear::LinearSeries;

/// What the order of the equations is given to: the equations, and the distances of the feet.
pub type TakeOrder<'t> = dyn FnMut(&dyn KernelView<f64>, &[f64]) + 't;

/// A model's full equations on Taylor series.
pub trait KernelOrders {
    /// The entries of M and J that vary.
    fn varying(&self) -> Varying<'_>;
    /// Order n of the equations from that of the full state, once those below have been computed.
    fn order(&mut self, n: usize, state: &[f64], take: &mut TakeOrder<'_>);
}

/// A source of Taylor coefficients of a projected phase; it keeps those of the last expansion.
pub struct ProjectedExpansion<'a> {
    orders: Box<dyn KernelOrders + 'a>,
    layout: &'static Layout,
    set: ContactSet,
    /// The closed rows.
    closed: Vec<usize>,
    system: LinearSeries,
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

impl<'a> ProjectedExpansion<'a> {
    /// That of a contact set; none where contacts slide or hinges have friction.
    pub fn of(layout: &'static Layout, set: ContactSet, orders: Box<dyn KernelOrders + 'a>) -> Option<Self> {
        if layout.has_hinges() || layout.sliding(&set).next().is_some() {
            return None;
        }
        let closed: Vec<usize> = (0..layout.rows()).filter(|&row| layout.is_closed(row, &set)).collect();
        let (n, entries) = (layout.coordinates.len(), layout.entries());
        let width = if layout.contacts.is_empty() { 0 } else { 2 * layout.reactions() + 2 * layout.feet() };
        let system = LinearSeries::of(n, &closed, orders.varying());
        Some(Self {
            orders,
            layout,
            set,
            closed,
            system,
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
        })
    }

    /// Order n of everything from that of the state.
    fn order(&mut self, n: usize, state: &[f64], rates: &mut [f64], guard: &mut [f64]) {
        let Self { orders, layout, set, closed, system, .. } = self;
        let (coordinates, contacts) = (layout.coordinates.len(), layout.contacts.len());
        orders.order(n, state, &mut |kernel, feet| {
            system.next(n, kernel, closed);
            if guard.is_empty() {
                return;
            }
            let (reactions, rest) = guard.split_at_mut(layout.reactions());
            let (gaps, distances) = rest.split_at_mut(layout.reactions());
            for (entry, reaction) in reactions.iter_mut().enumerate() {
                let row = closed.iter().position(|&row| row == layout.row_of_reaction(entry));
                *reaction = row.map_or(0.0, |k| system.solution[coordinates + k]);
            }
            for (i, gap) in gaps[..contacts].iter_mut().enumerate() {
                *gap = if set.contains(i) { 0.0 } else { kernel.gap()[i] };
            }
            distances.copy_from_slice(feet);
        });
        rates[..coordinates].copy_from_slice(&state[coordinates..2 * coordinates]);
        rates[coordinates..2 * coordinates].copy_from_slice(&self.system.solution[..coordinates]);
        for (entry, rate) in rates.iter_mut().enumerate().skip(2 * coordinates) {
            *rate = if n == 0 { self.layout.slope(entry) as f64 } else { 0.0 };
        }
    }

    /// Order 0 at a state, unless it is known.
    fn begin(&mut self, state: &[f64]) {
        if self.values.known && self.values.state == state {
            return;
        }
        let [mut rates, mut guard] = [&mut self.values.rates, &mut self.values.guard].map(core::mem::take);
        self.order(0, state, &mut rates, &mut guard);
        (self.values.known, self.values.rates, self.values.guard) = (true, rates, guard);
        self.values.state.copy_from_slice(state);
    }
}

impl SeriesExpansion for ProjectedExpansion<'_> {
    fn expand(&mut self, state: &[f64], unit: f64, order: usize) {
        let (entries, width) = (state.len(), self.values.guard.len());
        self.begin(state);
        self.terms = if width == 0 { 0 } else { order };
        let [mut series, mut guards] = [&mut self.series, &mut self.guards].map(core::mem::take);
        series[..entries].copy_from_slice(state);
        guards[..width].copy_from_slice(&self.values.guard);
        for (next, rate) in series[entries..].iter_mut().zip(&self.values.rates) {
            *next = unit * rate;
        }
        // The orders that follow write over some of it.
        self.values.known = false;
        for n in 1..order {
            let (below, above) = series.split_at_mut((n + 1) * entries);
            let rates = &mut above[..entries];
            self.order(n, &below[n * entries..], rates, &mut guards[n * width..][..width]);
            let part = unit / (n + 1) as f64;
            rates.iter_mut().for_each(|rate| *rate *= part);
        }
        (self.series, self.guards) = (series, guards);
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
        let (reactions, rest) = self.scaled.split_at(self.layout.reactions());
        let (gaps, feet) = rest.split_at(self.layout.reactions());
        Some(Guards::new(self.terms, reactions, gaps, feet))
    }
}
