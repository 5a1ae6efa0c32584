//! What every motion satisfies, checked at the ends of phases and at impacts: it costs nothing per step.

use super::Driver;
use crate::audit::{Bounds, Finding, Place, Quantity, Seam, energy_finding, gain};
use crate::integrate::Counts;
use crate::model::{ContactSet, Energy};
use crate::simulation::{RunCause, Simulation};
use crate::trajectory::{LogEntry, Work};

impl Driver<'_> {
    /// Refuses the end of a phase that has left its contacts, or whose energy has changed by anything but work.
    pub(super) fn refuse_drift(&self, counts: Counts, work: &Work, log: &[LogEntry]) -> Result<(), RunCause> {
        let place =
            Place { context: &self.setup.context, set: self.closed, absent: self.absent(), t: self.t };
        let bounds = Bounds::of(self.setup.tolerance, counts.accepted + counts.rejected).past(log);
        let now = self.setup.context.system().energy(&self.state);
        let kept = energy_finding(&self.setup.context, self.t, [&self.energy, &now], (work, &bounds));
        refuse(place.gaps(&self.state, &bounds).chain([kept]))
    }

    /// Refuses a phase that does not begin as the one before has ended.
    pub(super) fn refuse_seam(&self) -> Result<(), RunCause> {
        if self.ended.is_empty() {
            return Ok(());
        }
        let Simulation { context, tolerance, .. } = self.setup;
        let seam = Seam { context, t: self.t, tolerance: *tolerance, is_struck: self.is_struck };
        refuse(seam.compare(&self.ended, &self.state).into_iter().flatten())
    }

    /// Refuses an impact, without an impulse from outside, that has gained more energy than its law has told.
    pub(super) fn refuse_gain(&self, before: &Energy<f64>, told: f64) -> Result<(), RunCause> {
        if self.layout().timed {
            return Ok(());
        }
        let now = self.setup.context.system().energy(&self.state);
        let bound = Bounds::of(self.setup.tolerance, 1).impact();
        refuse([Finding {
            t: self.t,
            quantity: Quantity::Impact,
            value: gain(&self.setup.context.scales, [before, &now], told),
            bound,
        }])
    }

    /// Contacts that do not exist, drives that do not hold, and those that have come below their bars from beyond the ends.
    fn absent(&self) -> ContactSet {
        self.removed.union(self.sunk).union(self.waiting()).union(self.passed)
    }

    /// Open corners that lie below their bars.
    pub(super) fn below(&self) -> ContactSet {
        let (gaps, bound) = (self.gaps(), self.gap_bounds());
        let below = |i: &usize| self.layout().contacts[*i].foot.is_some() && gaps[*i] < -bound(*i);
        (0..gaps.len()).filter(below).collect()
    }
}

fn refuse(findings: impl IntoIterator<Item = Finding>) -> Result<(), RunCause> {
    let worst = findings.into_iter().find(Finding::is_violation);
    worst.map_or(Ok(()), |finding| Err(RunCause::Invariant(finding)))
}
