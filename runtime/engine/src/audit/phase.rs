//! One phase of a motion.

use super::finding::largest;
use super::place::worst;
use super::{Audit, AuditBounds, AuditPoint, Finding, Quantity};
use crate::context::RunContext;
use crate::event::detection::Guard;
use crate::expression::Variable;
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Energy};
use crate::numerics::zero::roundoff;
use crate::trajectory::{LoggedDecision, RecordedPhase, Trajectory, Work, blur};

/// Roundings of the terms of the equations in a step.
const ROUNDING: f64 = roundoff(16.0);
/// Halvings of the time in which a gap becomes negative.
const HALVINGS: usize = 40;

impl Trajectory {
    /// `passed`: open contacts that have not come back from below.
    pub(super) fn look_into(
        &self,
        (phase, ended_by): (&RecordedPhase, &[Guard]),
        passed: &mut ContactSet,
        audit: &mut Audit,
    ) {
        let times: Vec<f64> = phase.times().collect();
        let between = times.windows(2).flat_map(|t| [t[0], 0.5 * (t[0] + t[1])]);
        let seen: Vec<f64> = between.chain(times.last().copied()).collect();
        let bounds = AuditBounds::new(self.tolerance, times.len() as u64);
        let mut before = phase.t0;
        for &t in &seen {
            let point = phase.interpolate(t);
            *passed = self.find_passed(phase, (before, &point), *passed);
            before = t;
            let (set, absent) = (phase.segment().set, phase.removed.union(*passed));
            let place = AuditPoint { context: &self.context, set, absent, t };
            place.gaps(point.state(), &bounds).for_each(|finding| audit.note(finding));
        }
        if let Some(finding) = self.pull((phase, ended_by), &seen, &bounds) {
            audit.note(finding);
        }
        self.look_at_energy(phase, &times, audit);
    }

    /// The distance within which a foot counts as at the end of its bar.
    fn margin(&self) -> f64 {
        AuditBounds::new(self.tolerance, 1).gap() * self.context.scales.length
    }

    /// Open contacts below their grounds at a point of a phase.
    pub(super) fn find_sunk(&self, phase: &RecordedPhase, point: &PhasePoint) -> ContactSet {
        let (gaps, closed) = (self.context.gaps(point.state()), phase.segment().set);
        let (bound, length) = (AuditBounds::new(self.tolerance, 1).gap(), self.context.scales.length);
        let margin = |i: usize| bound * self.context.layout().unit(i, length);
        (0..gaps.len()).filter(|&i| gaps[i] < -margin(i) && !closed.contains(i)).collect()
    }

    /// Contacts beyond the ends of their bars, and those that have not come back from below, where
    /// those `known` were before.
    fn find_passed(
        &self,
        phase: &RecordedPhase,
        (before, point): (f64, &PhasePoint),
        known: ContactSet,
    ) -> ContactSet {
        let gaps = self.context.gaps(point.state());
        let sank = self.find_sunk(phase, point).difference(known);
        let came = sank.iter().filter(|&i| self.sank_off(phase, i, [before, point.t()])).collect();
        let below: ContactSet = known.union(came).iter().filter(|&i| gaps[i] < 0.0).collect();
        below.union(self.context.find_beyond_end(point.state(), self.margin()))
    }

    /// Whether the foot of a gap that has become negative between two times was off its bar where
    /// it did.
    fn sank_off(&self, phase: &RecordedPhase, contact: usize, [before, t]: [f64; 2]) -> bool {
        if self.layout().contacts[contact].foot.is_none() {
            return false;
        }
        let (mut above, mut below) = (before, t);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (above + below);
            let gap = self.context.gaps(phase.interpolate(middle).state())[contact];
            *if gap < 0.0 { &mut below } else { &mut above } = middle;
        }
        self.context.find_beyond_end(phase.interpolate(below).state(), self.margin()).contains(contact)
    }

    /// The largest pull of a contact that can only push, or only pull the other way. Where
    /// reactions are not unique, those given need not be possible ones. Where a contact opens its
    /// reaction has either sign: it may be at a pole.
    fn pull(
        &self,
        (phase, ended_by): (&RecordedPhase, &[Guard]),
        seen: &[f64],
        bounds: &AuditBounds,
    ) -> Option<Finding> {
        let free = phase.segment().set.difference(phase.held);
        let opens = |t: f64, i: &usize| {
            let turns = |guard: &Guard| matches!(guard, Guard::Reaction(of) | Guard::Side(of, _) if of == i);
            t == phase.t1 && ended_by.iter().any(turns)
        };
        let vague = |decision: &LoggedDecision| matches!(decision, LoggedDecision::ReactionsNotUnique);
        if free.is_empty() || self.log.iter().any(|entry| vague(&entry.decision)) {
            return None;
        }
        let reactions: Vec<_> = seen.iter().map(|&t| (t, phase.interpolate(t).reactions())).collect();
        let set = phase.segment().set;
        let pull = |i: usize, all: &[f64]| -f64::from(set.side(i).sign()) * all[i];
        let pulled = |t: f64, all: &[f64]| worst(free.iter().filter(|i| !opens(t, i)).map(|i| pull(i, all)));
        let largest = reactions.iter().flat_map(|(_, all)| all.iter().map(|r| r.abs()));
        let scales = self
            .context
            .scales
            .moving_at(self.layout(), &phase.interpolate(phase.t0).state()[self.context.rates()]);
        let size = largest.fold(scales.force().max(f64::MIN_POSITIVE), f64::max);
        let pulls = reactions.iter().filter_map(|(t, all)| Some((*t, pulled(*t, all)?)));
        let (t, pull) = pulls.reduce(|a, b| if a.1.is_nan() || b.1 <= a.1 { a } else { b })?;
        Some(Finding { t, quantity: Quantity::Pull, value: pull / size, bound: bounds.pull() })
    }

    /// The energy at the ends of steps against that at the start and the work since.
    fn look_at_energy(&self, phase: &RecordedPhase, times: &[f64], audit: &mut Audit) {
        let context = &self.context;
        let logged = self.log.iter().filter(|entry| phase.t0 <= entry.t && entry.t <= phase.t1);
        let bounds = AuditBounds::new(self.tolerance, times.len() as u64).past(logged);
        let begun = phase.interpolate(phase.t0);
        let start = context.system().energy(begun.state());
        let mut work = Work::default();
        let [_, mut lost] = self.rounding(&begun, 0.0);
        let mut rounding = 0.0;
        for step in times.windows(2) {
            if !context.is_conservative() {
                work.add(context, phase, [step[0], step[1]]);
            }
            let point = phase.interpolate(step[1]);
            let now = context.system().energy(point.state());
            if step[1] < phase.t1 && !(now.kinetic + now.potential).is_finite() {
                // Where the ends of a spring meet it has no direction; what follows is compared
                // with the start as well.
                continue;
            }
            let length = step[1] - step[0];
            let [of_power, of_position] = self.rounding(&point, length);
            rounding += of_power + blur(context, &point, length);
            lost = of_position.max(lost);
            work.note(&now);
            let finding = energy_finding(context, step[1], [&start, &now], (&work, &bounds));
            let size = work.size(largest(&context.scales, &start, &now));
            audit.note(Finding { bound: finding.bound + (rounding + lost) / size, ..finding });
        }
    }

    /// Roundoff of uᵀ (M a − f) over a step, from its terms: near singular positions these are
    /// larger by far than what they add up to. Then what the rounding of the position makes of the
    /// energy, Σ |fᵢ| δqᵢ: a stiff spring may be hardly longer than without load.
    fn rounding(&self, point: &PhasePoint, step: f64) -> [f64; 2] {
        let (layout, state, a) = (self.layout(), point.state(), point.accelerations());
        let equations = self.context.system().equations(state);
        let along = |i: usize| {
            let inertia = equations.mass(i).iter().zip(a).map(|(m, a)| (m * a).abs()).sum::<f64>();
            step * state[a.len() + i].abs() * (inertia + equations.force()[i].abs())
        };
        let places = (0..layout.points.len()).flat_map(|index| [0, 1].map(|axis| (index, axis)));
        let place =
            |(index, axis)| Variable::Point { index, axis, order: 0 }.value(&self.context, point).abs();
        let far = places.map(place).fold(self.context.scales.length, f64::max);
        let beside = |i: usize| {
            let unit = if layout.coordinates[i].is_angle { 1.0 } else { far };
            unit * equations.force()[i].abs()
        };
        [(0..a.len()).map(along).sum::<f64>(), (0..a.len()).map(beside).sum::<f64>()]
            .map(|sum| ROUNDING * sum)
    }
}

/// How much the energy of a phase has changed beside the work, relative to the largest of them.
pub(crate) fn energy_finding(
    context: &RunContext,
    t: f64,
    [start, now]: [&Energy<f64>; 2],
    (work, bounds): (&Work, &AuditBounds),
) -> Finding {
    let size = work.size(largest(&context.scales, start, now));
    let value = (now.gained_since(start) - work.done).abs() / size;
    Finding { t, quantity: Quantity::Energy, value, bound: bounds.energy() }
}
