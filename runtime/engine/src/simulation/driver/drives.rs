//! Drives on conditions: they take hold where what they drive has its value, and are held from there as supports can be.

use super::Driver;
use crate::model::ContactSet;

impl Driver<'_> {
    /// Drives hold from now on, whatever their reaction.
    pub(super) fn take_hold(&mut self, set: ContactSet) {
        self.held = self.held.union(set.intersection(self.layout().drives()));
    }

    /// The drives that wait for what they drive to come.
    pub(super) fn waiting(&self) -> ContactSet {
        self.layout().drives().difference(self.closed)
    }

    /// The drives of a set whose gaps are zero.
    pub(super) fn met(&self, set: ContactSet) -> ContactSet {
        let (layout, scales) = (self.layout(), &self.setup.context.scales);
        let equations = self.setup.context.system().equations(&self.state);
        let zero =
            |i: &usize| equations.gap()[*i].abs() <= self.relative_bound() * layout.unit(*i, scales.length);
        set.intersection(layout.drives()).iter().filter(zero).collect()
    }

    /// Whether a drive of a set is not as fast as what it is to hold.
    pub(super) fn differs(&self, set: ContactSet) -> bool {
        let (layout, scales) = (self.layout(), &self.setup.context.scales);
        let equations = self.setup.context.system().equations(&self.state);
        let n = layout.coordinates.len();
        let bound = |i: usize| self.relative_bound() * layout.unit(i, scales.length) / scales.time;
        set.iter().any(|i| equations.gap_rate(i, &self.state[n..2 * n]).abs() > bound(i))
    }
}
