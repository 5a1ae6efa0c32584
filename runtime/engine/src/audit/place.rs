//! The contacts at one state.

use super::finding::SMALL;
use super::{Bounds, Finding, Quantity};
use crate::integration::phase_point::RunContext;
use crate::model::ContactSet;

/// A time of a phase.
pub(crate) struct Place<'a> {
    pub(crate) context: &'a RunContext,
    /// The closed contacts.
    pub(crate) set: ContactSet,
    /// Contacts that do not exist.
    pub(crate) absent: ContactSet,
    pub(crate) t: f64,
}

impl Place<'_> {
    /// The largest gap and rate of what is closed, and the deepest penetration of what is open.
    pub(crate) fn gaps(&self, state: &[f64], bounds: &Bounds) -> Vec<Finding> {
        let (context, layout) = (self.context, self.context.layout());
        let n = layout.coordinates.len();
        let equations = context.system().equations(state);
        let far = (0..n).map(|i| state[i].abs() / context.scales.entry(layout, i)).fold(1.0, f64::max);
        let length = far * context.scales.length;
        let closed = || (0..layout.rows()).filter(|&row| layout.is_closed(row, self.set));
        let gap = closed().map(|row| equations.gap()[row].abs() / length);
        let rate = closed().map(|row| {
            let along = equations.jacobian(row).iter().zip(&state[n..2 * n]).map(|(entry, u)| entry * u);
            let terms = along.clone().map(f64::abs).sum::<f64>() + equations.drift()[row].abs();
            let rate = along.sum::<f64>() + equations.drift()[row];
            if rate == 0.0 { 0.0 } else { rate.abs() / terms.max(SMALL * context.scales.speed()) }
        });
        let open = |i: &usize| !self.set.contains(*i) && !self.absent.contains(*i);
        let depth = (0..layout.contacts.len()).filter(open).map(|i| -equations.gap()[i] / length);
        let finding = |quantity, value, bound| Finding { t: self.t, quantity, value, bound };
        [
            (Quantity::Gap, worst(gap), bounds.gap()),
            (Quantity::Rate, worst(rate), bounds.rate()),
            (Quantity::Penetration, worst(depth), bounds.gap()),
        ]
        .into_iter()
        .filter_map(|(quantity, value, bound)| value.map(|value| finding(quantity, value, bound)))
        .collect()
    }
}

/// The largest, not a number if one is none.
pub(super) fn worst(values: impl Iterator<Item = f64>) -> Option<f64> {
    values.reduce(|a, b| if a.is_nan() || b <= a { a } else { b })
}
