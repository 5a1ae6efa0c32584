//! The first event of all guards of a phase in a step.

use std::cell::RefCell;

use super::contact_status::ContactStatus;
use super::friction_work::compute_friction_power;
use super::guard_source;
use super::guards::{Findings, Kind, Tracking, list_guards};
use super::sample::Quantities;
use super::sampled_step::{SampledStep, Scales};
use super::samples::Samples;
use super::step::StepView;
use super::{Bounds, Guard, LOW, StepEvents};
use crate::context::Numbers;
use crate::expression::Condition;
use crate::model::{ContactSet, Layout};
use crate::numerics::root_isolation::{GuardError, NODES};
use smallvec::SmallVec;

/// Where a guard that began a step at zero is looked at: a flight may be over in a single step.
const WITHIN: [f64; 4] = [1.0, 0.75, 0.5, 0.25];
/// The fraction of a run's last step over which a guard must fall to count as zero at its end.
const LAST: f64 = 1.0 / 64.0;

/// A guard with what is known of it.
pub(super) struct Watch<'a> {
    pub(super) guard: Kind<'a>,
    pub(super) tracking: Tracking,
}

impl Watch<'_> {
    /// The first event in a step.
    fn find_event(
        &mut self,
        step: &SampledStep<'_>,
        findings: &mut Findings,
    ) -> Result<Option<f64>, GuardError> {
        if self.tracking.is_clear { Ok(None) } else { self.guard.find_event(self.tracking, step, findings) }
    }

    /// The same in a step that cannot be made shorter, as far as its samples show it.
    fn find_event_in_noise(&mut self, step: &SampledStep<'_>, findings: &mut Findings) -> Option<f64> {
        let tracking = Tracking { is_noisy: true, ..self.tracking };
        self.guard.find_event(tracking, step, findings).unwrap_or(None)
    }

    /// Whether it has fallen into its bound at the end of the step, and not with a turning point there: it falls by as much
    /// as before.
    fn arrives(&self, step: &SampledStep<'_>) -> bool {
        let Self { guard, tracking } = self;
        if tracking.is_clear || tracking.at_root || !guard.may_arrive(step) {
            return false;
        }
        let [before, near, end] = [1.0 - 2.0 * LAST, 1.0 - LAST, 1.0].map(|theta| guard.value(step, theta));
        let bound = guard.bound(step, &[]);
        end.abs() <= bound && near - end > bound && near - end > 0.75 * (before - near)
    }
}

/// All guards of a phase.
pub(crate) struct EventDetector<'a> {
    pub(super) list: Vec<Watch<'a>>,
    pub(super) scales: Scales<'a>,
    pub(super) samples: RefCell<Samples>,
    /// Slip velocities without rates, where friction is all that works.
    at_rest: Option<Numbers>,
    /// The guard that was not resolved.
    unresolved: Option<Guard>,
    /// Where a condition may hide a root beside a pole in the last step.
    undecided: Option<f64>,
}

impl<'a> EventDetector<'a> {
    /// Of a phase in which the contacts of a set bear; with each condition that is located whether it arms or disarms.
    pub(crate) fn new(
        layout: &'static Layout,
        set: ContactSet,
        status: ContactStatus<'a>,
        conditions: (&'a [Condition], &[(usize, bool)]),
        bounds: Bounds,
    ) -> Self {
        let mut list = Vec::with_capacity(layout.contacts.len() + conditions.1.len());
        list_guards(layout, &set, &status, conditions, &mut |guard| {
            list.push(Watch { guard, tracking: Tracking::default() });
        });
        let ContactStatus { forces, slips, .. } = status;
        Self {
            list,
            scales: Scales { bounds, layout, forces, slips, roundings: Numbers::new() },
            samples: RefCell::new(Samples::of(layout)),
            at_rest: None,
            unresolved: None,
            undecided: None,
        }
    }

    /// From now on the guard that was not resolved is taken for noise where it turns too often to be followed.
    pub(crate) fn expect_noise(&mut self) {
        let noisy = |watch: &&mut Watch<'_>| self.unresolved == Some(watch.guard.guard());
        self.list.iter_mut().filter(noisy).for_each(|watch| watch.tracking.is_noisy = true);
    }

    /// The power of friction at the nodes of the last step, where all of it is known from the guards.
    pub(crate) fn friction_powers(&self) -> Option<[f64; NODES.len()]> {
        let (at_rest, samples) = (self.at_rest.as_deref()?, self.samples.borrow());
        let nodes = samples.at_nodes(Quantities::REACTIONS.and(Quantities::SLIPS))?;
        Some(nodes.each_ref().map(|node| compute_friction_power(self.scales.layout, node, at_rest)))
    }

    /// The work of friction over a step up to `end`, where the method has the series of all that it takes.
    pub(crate) fn friction_work(&self, step: &StepView<'_>, end: f64) -> Option<f64> {
        let Scales { bounds: Bounds { relative, .. }, layout, forces, slips, .. } = self.scales;
        step.friction_work(end, self.at_rest.as_deref()?, &|contact, [force, slip], at_rest| {
            let slow = layout.contacts[contact].friction.map_or(0.0, |k| slips[k]);
            let fastest = (slip[0] - at_rest).abs() + slip[1..].iter().map(|term| term.abs()).sum::<f64>();
            // Where nothing slips the force does no work, however well it is known.
            let share = if fastest <= relative * slow { 1.0 } else { relative };
            guard_source::is_exact(force, share * forces[contact])
                && guard_source::is_exact(slip, relative * slow)
        })
    }

    /// The guard of the last step that was not resolved.
    pub(crate) fn unresolved(&self) -> Option<Guard> {
        self.unresolved
    }

    /// Where in the last step it was not decided whether a condition is met, if it was not.
    pub(crate) fn undecided(&self) -> Option<f64> {
        self.undecided
    }

    /// Whether a reaction or gap that touches zero may as well have crossed it: at the touch it differs from zero by more than
    /// rounding, yet by less than its bound.
    pub(crate) fn is_undecided(&self, guard: Guard, reactions: &[f64], gaps: &[f64]) -> bool {
        let watch = self.list.iter().find(|watch| watch.guard.guard() == guard);
        watch.is_some_and(|watch| watch.guard.may_have_crossed(&self.scales, reactions, gaps))
    }

    /// Contacts whose gaps close at a place of a step at which they are seen to be below zero, and
    /// have not been seen to be above since the phase began.
    pub(crate) fn unseen_landings(&self, view: &StepView<'_>, theta: f64, guards: &[Guard]) -> ContactSet {
        let step = &self.sampled(view);
        let landing = |Watch { guard, tracking }: &Watch<'_>| {
            let contact = guard.guard().gap().filter(|_| tracking.at_root)?;
            let is_below = || guard.value(step, theta) < -0.5 * guard.bound(step, &[]);
            (guards.contains(&guard.guard()) && is_below()).then_some(contact)
        };
        self.list.iter().filter_map(landing).collect()
    }

    /// A step with the samples of the last one that was examined.
    pub(super) fn sampled<'s>(&'s self, view: &'s StepView<'s>) -> SampledStep<'s> {
        SampledStep { view, samples: &self.samples, scales: &self.scales }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Marks the guards that are zero at the start of the phase as known roots; `start` is a dense output at rest there.
    pub(crate) fn begin(&mut self, start: &StepView<'_>) {
        let least = self.least_bound();
        let Self { list, scales, samples, at_rest, .. } = self;
        let known = samples.get_mut();
        let asked = list.iter().fold(Quantities::NONE, |asked, watch| asked.and(watch.guard.asked()));
        if !asked.have(Quantities::GRIP) {
            *at_rest = start.slips_at_rest(&mut known.scratch);
        }
        if asked != Quantities::NONE {
            known.begin(start, asked);
        }
        if asked.have(Quantities::GAPS) {
            scales.roundings = start.context.roundings(&known.scratch.state, least);
        }
        let step = &SampledStep { view: start, samples, scales };
        list.iter_mut().for_each(|watch| watch.tracking.at_root = watch.guard.begin(step));
    }

    /// The height of the lowest flight that the phase begins with; zero if a guard is zero there of which nothing is known.
    pub(crate) fn lowest_flight(&self) -> f64 {
        let zero = self.list.iter().filter(|watch| watch.tracking.at_root).map(|watch| watch.guard.height());
        zero.map(|height| if height.is_finite() { height } else { 0.0 }).reduce(f64::min).unwrap_or(0.0)
    }

    /// The least bound of a gap, in its own unit.
    fn least_bound(&self) -> f64 {
        let Bounds { relative, length } = self.scales.bounds;
        let lowest = self.list.iter().map(|watch| watch.guard.height()).fold(f64::INFINITY, f64::min);
        relative.min(LOW * lowest / length)
    }

    /// Corners below their bars, which they have come to from beyond the ends.
    pub(crate) fn passed(&self) -> ContactSet {
        let passed = self.list.iter().filter(|watch| watch.guard.has_passed());
        passed.filter_map(|watch| watch.guard.guard().contact()).collect()
    }

    /// Everything in (0, 1] up to the first event. On the last step a guard that has fallen to zero within rounding at its end
    /// counts as well: no later step would find it.
    pub(crate) fn examine(&mut self, view: &StepView<'_>, is_last: bool) -> Result<StepEvents, GuardError> {
        self.begin_step(view);
        let Self { list, scales, samples, unresolved, undecided, .. } = self;
        let step = &SampledStep { view, samples, scales };
        let mut findings = Findings::default();
        let mut decisive: SmallVec<[(f64, Guard); 4]> = SmallVec::new();
        (*unresolved, *undecided) = (None, None);
        for watch in &mut *list {
            let known = findings.touches.len();
            let event = match watch.find_event(step, &mut findings) {
                Ok(event) => event,
                Err(error) => {
                    *unresolved = Some(watch.guard.guard());
                    if !view.is_bridge() {
                        return Err(error);
                    }
                    findings.touches.truncate(known);
                    watch.find_event_in_noise(step, &mut findings)
                }
            };
            let arrival = || (is_last && watch.arrives(step)).then_some(1.0);
            decisive.extend(event.or_else(arrival).map(|theta| (theta, watch.guard.guard())));
        }
        *undecided = findings.undecided;
        let mut touches = findings.touches;
        let first = decisive.iter().map(|(theta, _)| *theta).min_by(f64::total_cmp);
        touches.retain(|(theta, _)| first.is_none_or(|first| *theta < first));
        touches.sort_by(|a, b| a.0.total_cmp(&b.0));
        let first = first.map(|first| (first, find_together(list, step, first, &decisive)));
        let end = first.as_ref().map_or(1.0, |(theta, _)| theta.min(1.0));
        for Watch { guard, tracking } in list {
            guard.end_step(*tracking, step, end);
            // No step follows an event, but what seems one across a singular position may be none.
            if first.is_none() || view.is_bridge() {
                guard.leave_step(step);
                tracking.at_root = tracking.at_root && WITHIN.iter().all(|theta| guard.is_zero(step, *theta));
            }
        }
        Ok(StepEvents { touches, first })
    }

    /// Proves of guards by their series that nothing happens to them in a step, as far as they tell, and evaluates the others at its
    /// nodes.
    pub(super) fn begin_step(&mut self, view: &StepView<'_>) {
        let least = self.least_bound();
        let Self { list, scales, samples, .. } = self;
        if let Some(roundings) = view.roundings(least, &mut samples.get_mut().scratch) {
            scales.roundings = roundings;
        }
        let step = &SampledStep { view, samples, scales };
        for Watch { guard, tracking } in &mut *list {
            guard.begin_step(view);
            [tracking.has_series, tracking.is_clear] = guard.series(view).map_or([false; 2], |series| {
                let bound = guard.bound(step, &[]);
                [guard_source::is_exact(series, bound), guard_source::is_clear(series, bound)]
            });
        }
        let sampled = list.iter().filter(|watch| watch.tracking.is_sampled());
        samples.get_mut().begin_step(view, sampled.map(|watch| watch.guard.asked()));
    }
}

/// The decisive guards at `theta`, and all others that are zero within their bound.
fn find_together(
    list: &[Watch<'_>],
    step: &SampledStep<'_>,
    theta: f64,
    decisive: &[(f64, Guard)],
) -> Vec<Guard> {
    let is_together = |Watch { guard, tracking }: &&Watch<'_>| {
        let (name, last) = (guard.guard(), theta + guard.precedence());
        let is_met = decisive.iter().any(|(at, other)| *other == name && (theta..=last).contains(at));
        let is_zero = || !guard.is_above(*tracking, step, theta) && guard.is_zero(step, theta);
        is_met || !tracking.at_root && is_zero()
    };
    list.iter().filter(is_together).map(|watch| watch.guard.guard()).collect()
}
