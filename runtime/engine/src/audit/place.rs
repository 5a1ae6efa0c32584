//! The contacts at one state.

use super::finding::SMALL;
use super::{AuditBounds, Finding, Quantity};
use crate::context::{ROUNDINGS, RunContext};
use crate::integration::chart::nan_max;
use crate::model::ContactSet;

/// Where gaps are flat, positions within the bound of a gap leave J unknown by the root of that:
/// about this part of the bound of rates.
const FLAT: f64 = 0.1;

/// A time of a phase.
pub(crate) struct AuditPoint<'a> {
    pub(crate) context: &'a RunContext,
    /// The closed contacts.
    pub(crate) set: ContactSet,
    /// Contacts that do not exist.
    pub(crate) absent: ContactSet,
    pub(crate) t: f64,
}

impl AuditPoint<'_> {
    /// The largest gap and rate of what is closed, and the deepest penetration of what is open.
    pub(crate) fn gaps(&self, state: &[f64], bounds: &AuditBounds) -> impl Iterator<Item = Finding> {
        let [far, rounding] = self.context.travelled(state, self.t);
        let length = (far + rounding / bounds.gap()) * self.context.scales.length;
        let [gap, rate] = self.closed(state, length, bounds.gap());
        let found = [
            (Quantity::Gap, gap, bounds.gap()),
            (Quantity::Rate, rate, bounds.rate()),
            (Quantity::Penetration, self.open(state, length), bounds.gap()),
        ];
        let t = self.t;
        found.into_iter().filter_map(move |(quantity, value, bound)| {
            value.map(|value| Finding { t, quantity, value, bound })
        })
    }

    fn closed(&self, state: &[f64], length: f64, bound: f64) -> [Option<f64>; 2] {
        let (context, layout) = (self.context, self.context.layout());
        let rows = || (0..layout.rows()).filter(|&row| layout.is_closed(row, &self.set));
        if rows().next().is_none() {
            return [None; 2];
        }
        let equations = context.system().equations(state);
        let (positions, rates) = state.split_at(layout.coordinates.len());
        let rounding = |row: usize| ROUNDINGS * equations.terms(row, positions);
        let natural =
            rates.iter().zip(layout.coordinates).map(|(u, c)| u.abs() / context.scales.coordinate(c));
        let fastest = natural.fold(0.0, f64::max);
        let gap =
            |row: usize| equations.gap()[row].abs() / (layout.unit(row, length) + rounding(row) / bound);
        let rate = |row: usize| {
            let terms = equations.terms(row, rates) + equations.prescribed_gap_rate()[row].abs();
            let unit = layout.unit(row, context.scales.length);
            let flat = FLAT * unit * fastest;
            equations.gap_rate(row, rates).abs() / terms.max(flat).max(SMALL * unit / context.scales.time)
        };
        [worst(rows().map(gap)), worst(rows().map(rate))]
    }

    fn open(&self, state: &[f64], length: f64) -> Option<f64> {
        let contacts = self.context.layout().contacts.len();
        let open = |i: &usize| !self.set.contains(*i) && !self.absent.contains(*i);
        if !(0..contacts).any(|i| open(&i)) {
            return None;
        }
        let (gaps, layout) = (self.context.gaps(state), self.context.layout());
        worst((0..contacts).filter(open).map(|i| -gaps[i] / layout.unit(i, length)))
    }
}

/// The largest, not a number if one is none.
pub(super) fn worst(values: impl Iterator<Item = f64>) -> Option<f64> {
    values.reduce(nan_max)
}
