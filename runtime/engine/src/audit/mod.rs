//! What every motion satisfies, looked at in a finished one:
//!
//! ```text
//! q(t⁻) = q(t⁺)                               positions do not jump
//! u(t⁻) = u(t⁺)                               velocities do not, but at an impact
//! g = 0, ġ = 0, λ ≥ 0                         where a contact is closed
//! g ≥ 0                                       where it is open
//! T + V = T₀ + V₀ + ∫ P dt                    within a phase, P the power of loads, dampers and drives
//! T⁺ + V⁺ ≤ T⁻ + V⁻ + told                    at an impact, without an impulse from outside; told: what Newton's law has gained
//! ```

mod defect;
mod finding;
mod phase;
mod place;
#[cfg(test)]
mod tests;

use core::fmt;

pub(crate) use defect::work_of;
pub(crate) use finding::{AuditBounds, gain};
pub use finding::{Finding, Quantity};
pub(crate) use phase::energy_finding;
pub(crate) use place::AuditPoint;

use crate::context::RunContext;
use crate::event::{Event, Note};
use crate::integration::chart;
use crate::model::ContactSet;
use crate::trajectory::{LoggedDecision, RecordedPhase, Trajectory};

/// What was found in a motion: of each quantity the worst value relative to its bound.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Audit {
    worst: Vec<Finding>,
}

impl Audit {
    /// The worst of each quantity that there was anything to see of.
    pub fn worst(&self) -> &[Finding] {
        &self.worst
    }

    /// The quantities that are beyond their bounds.
    pub fn violations(&self) -> impl Iterator<Item = &Finding> {
        self.worst.iter().filter(|finding| finding.is_violation())
    }

    /// Whether nothing is beyond its bound.
    pub fn is_clean(&self) -> bool {
        self.violations().next().is_none()
    }

    fn note(&mut self, finding: Finding) {
        match self.worst.iter_mut().find(|worst| worst.quantity == finding.quantity) {
            Some(worst) if worst.is_worse_than(&finding) => {}
            Some(worst) => *worst = finding,
            None => self.worst.push(finding),
        }
    }
}

/// Where a motion is put together: the end of a step, a phase, a restart.
pub(crate) struct Seam<'a> {
    pub(crate) context: &'a RunContext,
    pub(crate) t: f64,
    pub(crate) tolerance: f64,
    /// Whether an impulse acts there.
    pub(crate) is_struck: bool,
}

impl Seam<'_> {
    /// How far positions are apart, and without an impulse velocities.
    pub(crate) fn compare(&self, before: &[f64], after: &[f64]) -> [Option<Finding>; 2] {
        let [positions, rates] = chart::apart(self.context, before, after);
        // Times are told apart by the spacing of doubles, in which a fast motion comes far.
        let [_, rounding] = self.context.travelled(before, self.t);
        let bound = AuditBounds::new(self.tolerance, 1).jump() + rounding;
        let finding = |quantity, value| Some(Finding { t: self.t, quantity, value, bound });
        let kick = if self.is_struck { None } else { finding(Quantity::Kick, rates) };
        [finding(Quantity::Jump, positions), kick]
    }
}

impl fmt::Display for Audit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for finding in &self.worst {
            writeln!(f, "{}  {finding}", if finding.is_violation() { "broken" } else { "    ok" })?;
        }
        write!(f, "{}", if self.is_clean() { "clean" } else { "not to be trusted" })
    }
}

impl Trajectory {
    /// Looks at the ends and in the middle of all steps whether the motion satisfies what every
    /// motion does.
    pub fn audit(&self) -> Audit {
        let mut audit = Audit::default();
        let mut passed = ContactSet::EMPTY;
        // A start may lie below edges, round whose ends it has gone; what is armed, below its
        // ground.
        let mut fresh = self.layout().edges();
        for (k, phase) in self.phases.iter().enumerate() {
            passed = passed.union(self.find_sunk(phase, &phase.interpolate(phase.t0)).intersection(fresh));
            self.look_into((phase, self.ended_by(k)), &mut passed, &mut audit);
            fresh = phase.removed;
        }
        for pair in self.phases.windows(2) {
            self.look_between([&pair[0], &pair[1]], &mut audit);
        }
        for pair in self.events.windows(2) {
            let value = pair[0].t - pair[1].t;
            audit.note(Finding { t: pair[1].t, quantity: Quantity::Order, value, bound: 0.0 });
        }
        audit
    }

    /// What changes from one phase to the next.
    fn look_between(&self, [before, after]: [&RecordedPhase; 2], audit: &mut Audit) {
        let (context, t) = (&self.context, after.t0);
        let [from, to] = [before.interpolate(before.t1), after.interpolate(t)];
        let bounds = AuditBounds::new(self.tolerance, 1);
        let seam = Seam { context, t, tolerance: self.tolerance, is_struck: after.is_struck };
        seam.compare(from.state(), to.state()).into_iter().flatten().for_each(|finding| audit.note(finding));
        audit.note(Finding { t, quantity: Quantity::Order, value: before.t1 - t, bound: 0.0 });
        // Surfaces that move do work in an impact.
        let moves =
            context.system().equations(to.state()).prescribed_gap_rate().iter().any(|drift| *drift != 0.0);
        let is_driven = context.layout().timed || moves;
        if !is_driven && self.impulses.iter().all(|impulse| impulse.t != t) {
            // A spring that comes or goes takes its energy with it.
            let left = context.switched_as(from.state(), to.state());
            let [old, new] = [&left, to.state()].map(|state| context.system().energy(state));
            let value = gain(&context.scales, [&old, &new], self.sum_recorded_gains(t));
            audit.note(Finding { t, quantity: Quantity::Impact, value, bound: bounds.impact() });
        }
    }

    /// The energy that the events and decisions at a time say that impacts have gained, J.
    fn sum_recorded_gains(&self, t: f64) -> f64 {
        let told = |event: &Event| match event.note {
            Some(Note::EnergyGained(energy)) => Some(energy),
            _ => None,
        };
        let from = self.events.partition_point(|event| event.t < t);
        let at_once = self.events[from..].iter().take_while(|event| event.t == t);
        let mut gains: Vec<f64> = at_once.filter_map(told).collect();
        gains.dedup();
        let ahead = self.log.iter().filter(|entry| entry.t == t).filter_map(|entry| match entry.decision {
            LoggedDecision::FrictionAhead(energy) => Some(energy),
            _ => None,
        });
        gains.into_iter().chain(ahead).sum()
    }
}
