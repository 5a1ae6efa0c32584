//! Drives on conditions: they take hold where what they drive has its value, and are held from
//! there as supports can be.

use nalgebra::DVector;

use crate::event::EventKind;
use crate::model::ContactSet;
use crate::numerics::zero::MARGIN;
use crate::simulation::RunCause;
use crate::simulation::decide::DecisionInput;
use crate::simulation::snapshot::Snapshot;

impl Snapshot<'_> {
    /// The drives of a set whose gaps are zero.
    pub(super) fn met(&self, set: ContactSet) -> ContactSet {
        let (layout, scales) = (self.layout(), &self.setup.context.scales);
        let equations = self.setup.context.system().equations(&self.state);
        let zero =
            |i: &usize| equations.gap()[*i].abs() <= self.relative_bound() * layout.unit(*i, scales.length);
        set.intersection(layout.drives()).iter().filter(zero).collect()
    }

    /// Whether what closes are drives alone, each as fast as what it is to hold.
    pub(super) fn meets_smoothly(&self, closing: ContactSet) -> bool {
        closing.difference(self.layout().drives()).is_empty() && !self.differs(closing)
    }

    /// Contacts close without an impulse, and drives among them take hold; the contacts that were
    /// closed before.
    pub(super) fn join(&mut self, set: ContactSet) -> Result<ContactSet, RunCause> {
        let before = self.closed();
        self.contacts.take_hold(set);
        self.go_on(DecisionInput { touching: before.union(set), ..self.question() })?;
        Ok(before)
    }

    /// Drives take hold without an impulse.
    pub(super) fn meet(&mut self, drives: ContactSet) -> Result<(), RunCause> {
        let before = self.join(drives)?;
        let none = DVector::zeros(self.layout().rows());
        self.record_impact(EventKind::Impact, drives, drives, (None, &none), None);
        self.record_changes(before);
        Ok(())
    }

    /// Whether a drive of a set is not as fast as what it is to hold.
    pub(super) fn differs(&self, set: ContactSet) -> bool {
        let (layout, scales) = (self.layout(), &self.setup.context.scales);
        let equations = self.setup.context.system().equations(&self.state);
        // Where it comes smoothly, the time is that of a double root, known to half of the digits.
        let least = self.relative_bound().max(MARGIN);
        let bound = |i: usize| least * layout.unit(i, scales.length) / scales.time;
        set.iter().any(|i| equations.gap_rate(i, self.rates()).abs() > bound(i))
    }
}
