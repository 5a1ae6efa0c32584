//! One phase of a motion.

use super::finding::largest;
use super::place::worst;
use super::power::work;
use super::{Audit, Bounds, Finding, Place, Quantity};
use crate::integration::phase_point::PhasePoint;
use crate::integration::phase_run::RecordedPhase;
use crate::model::ContactSet;
use crate::trajectory::{LoggedDecision, Trajectory};

impl Trajectory {
    /// `passed`: open contacts that lie below their bar, having come from beyond its end.
    pub(super) fn look_into(&self, phase: &RecordedPhase, passed: &mut ContactSet, audit: &mut Audit) {
        let times: Vec<f64> = phase.times().collect();
        let between = times.windows(2).flat_map(|t| [t[0], 0.5 * (t[0] + t[1])]);
        let seen: Vec<f64> = between.chain(times.last().copied()).collect();
        let bounds = Bounds::of(self.tolerance, times.len() as u64);
        for &t in &seen {
            let point = phase.at(t);
            self.pass(&point, passed);
            let (set, absent) = (phase.segment().set, phase.removed.union(*passed));
            let place = Place { context: &self.context, set, absent, t };
            place.gaps(point.state(), &bounds).for_each(|finding| audit.note(finding));
        }
        if let Some(finding) = self.pull(phase, &seen, &bounds) {
            audit.note(finding);
        }
        self.look_at_energy(phase, &times, audit);
    }

    fn pass(&self, point: &PhasePoint, passed: &mut ContactSet) {
        let layout = self.layout();
        let (mut feet, mut gaps) = (vec![0.0; 2 * layout.feet()], vec![0.0; layout.contacts.len()]);
        self.context.system().feet(point.state(), &mut feet);
        self.context.system().gaps(point.state(), &mut gaps);
        let margin = Bounds::of(self.tolerance, 1).gap() * self.context.scales.length;
        for (i, contact) in layout.contacts.iter().enumerate() {
            let off = contact.foot.is_some_and(|k| feet[2 * k..2 * k + 2].iter().any(|x| *x <= margin));
            *passed =
                if off || passed.contains(i) && gaps[i] < 0.0 { passed.with(i) } else { passed.without(i) };
        }
    }

    /// The largest pull of a contact that can only push, or only pull the other way. Where reactions are not unique, those given
    /// need not be possible ones.
    fn pull(&self, phase: &RecordedPhase, seen: &[f64], bounds: &Bounds) -> Option<Finding> {
        let free = phase.segment().set.difference(phase.held);
        let vague = |decision: &LoggedDecision| matches!(decision, LoggedDecision::ReactionsNotUnique);
        if free.is_empty() || self.log.iter().any(|entry| vague(&entry.decision)) {
            return None;
        }
        let reactions: Vec<_> = seen.iter().map(|&t| (t, phase.at(t).reactions())).collect();
        let largest = reactions.iter().flat_map(|(_, all)| all.iter().map(|r| r.abs()));
        let size = largest.fold(self.context.scales.force().max(f64::MIN_POSITIVE), f64::max);
        let pulls = reactions.iter().filter_map(|(t, all)| Some((*t, worst(free.iter().map(|i| -all[i]))?)));
        let (t, pull) = pulls.reduce(|a, b| if a.1.is_nan() || b.1 <= a.1 { a } else { b })?;
        Some(Finding { t, quantity: Quantity::Pull, value: pull / size, bound: bounds.pull() })
    }

    /// The energy at the ends of steps against that at the start and the work since.
    fn look_at_energy(&self, phase: &RecordedPhase, times: &[f64], audit: &mut Audit) {
        let (context, bounds) = (&self.context, Bounds::of(self.tolerance, times.len() as u64));
        let energy = |t: f64| context.system().energy(phase.at(t).state());
        let start = energy(phase.t0);
        let (mut done, mut size) = (0.0, 0.0_f64);
        for step in times.windows(2) {
            let now = energy(step[1]);
            if !context.is_conservative() {
                done += work(context, [step[0], step[1]], |t| phase.at(t));
            }
            size = size.max(largest(&context.scales, &start, &now));
            let off = now.gained_since(&start) - done;
            let value = off.abs() / size;
            audit.note(Finding { t: step[1], quantity: Quantity::Energy, value, bound: bounds.energy() });
        }
    }
}
