//! The Taylor series of a phase that keeps all coordinates, order by order: with K = [M −Jᵀ; J 0]
//! over the closed rows, x = (a, λ) and r = (f, −b),
//!
//! ```text
//! K₀ xₙ = rₙ − Σ Kₖ xₙ₋ₖ over 0 < k ≤ n
//! ```
//!
//! so that K is factorised once a step (the system of derivatives of index-reduced equations, as N.
//! S. Nedialkov and J. D. Pryce, *Solving differential-algebraic equations by Taylor series (I)*,
//! BIT 45, 2005, solve it).

mod factors;
mod linear;

use crate::model::{ContactSet, KernelView, Layout, Varying};
use crate::system::{ByOrders, SeriesExpansion, SeriesOrders};
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

/// The source of Taylor coefficients of a projected phase; none where contacts slide or hinges have
/// friction.
pub fn projected_series<'a>(
    layout: &'static Layout,
    set: ContactSet,
    orders: Box<dyn KernelOrders + 'a>,
) -> Option<Box<dyn SeriesExpansion + 'a>> {
    if layout.has_hinges() || layout.sliding(&set).next().is_some() {
        return None;
    }
    let closed: Vec<usize> = (0..layout.rows()).filter(|&row| layout.is_closed(row, &set)).collect();
    let system = LinearSeries::new(layout.coordinates.len(), &closed, orders.varying());
    let guards = [layout.reactions(), 2 * layout.feet()];
    let orders = ProjectedOrders { orders, layout, set, closed, system };
    Some(Box::new(ByOrders::new(orders, layout.entries(), guards)))
}

/// The motion in a contact set.
struct ProjectedOrders<'a> {
    orders: Box<dyn KernelOrders + 'a>,
    layout: &'static Layout,
    set: ContactSet,
    /// The closed rows.
    closed: Vec<usize>,
    system: LinearSeries,
}

impl SeriesOrders for ProjectedOrders<'_> {
    fn order(&mut self, n: usize, state: &[f64], rates: &mut [f64], guard: &mut [f64]) {
        let Self { orders, layout, set, closed, system } = self;
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
}
