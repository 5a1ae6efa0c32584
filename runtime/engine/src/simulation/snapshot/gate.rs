//! What every motion satisfies, checked at the ends of phases and at impacts: it costs nothing per
//! step.

use super::{PhaseStart, Snapshot};
use crate::audit::{AuditBounds, AuditPoint, Finding, Quantity, Seam, energy_finding, gain};
use crate::integrate::Counts;
use crate::model::Energy;
use crate::simulation::{RunCause, Simulation};
use crate::trajectory::{LogEntry, Work};

impl Snapshot<'_> {
    /// Refuses the end of a phase that has left its contacts, or whose energy has changed by
    /// anything but work.
    pub(in crate::simulation) fn refuse_drift(
        &self,
        start: &PhaseStart,
        counts: Counts,
        work: &Work,
        log: &[LogEntry],
    ) -> Result<(), RunCause> {
        let context = &self.setup.context;
        // Contacts that do not exist, drives that do not hold, and what has not come back.
        let absent = self.contacts.absent().union(self.contacts.waiting()).union(self.contacts.below());
        let place = AuditPoint { context, set: self.closed(), absent, t: self.t };
        let bounds = AuditBounds::new(self.setup.tolerance, counts.accepted + counts.rejected).past(log);
        let kept = energy_finding(context, self.t, [&start.energy, &self.energy()], (work, &bounds));
        refuse(place.gaps(&self.state, &bounds).chain([kept]))
    }

    /// Refuses a phase that does not begin as the one before has ended.
    pub(in crate::simulation) fn refuse_seam(&self, ended: &[f64]) -> Result<(), RunCause> {
        let Simulation { context, tolerance, .. } = self.setup;
        let seam = Seam { context, t: self.t, tolerance: *tolerance, is_struck: self.onset.is_struck };
        refuse(seam.compare(ended, &self.state).into_iter().flatten())
    }

    /// Refuses an impact, without an impulse from outside, that has gained more energy than its law
    /// has told.
    pub(in crate::simulation) fn refuse_gain(
        &self,
        before: &Energy<f64>,
        allowed: f64,
    ) -> Result<(), RunCause> {
        if self.layout().timed {
            return Ok(());
        }
        let now = self.energy();
        let bound = AuditBounds::new(self.setup.tolerance, 1).impact();
        refuse([Finding {
            t: self.t,
            quantity: Quantity::Impact,
            value: gain(&self.setup.context.scales, [before, &now], allowed),
            bound,
        }])
    }
}

fn refuse(findings: impl IntoIterator<Item = Finding>) -> Result<(), RunCause> {
    let worst = findings.into_iter().find(Finding::is_violation);
    worst.map_or(Ok(()), |finding| Err(RunCause::Invariant(finding)))
}
