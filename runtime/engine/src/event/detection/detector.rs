//! The first event of all guards of a phase in a step.

use std::cell::RefCell;

use super::contact_status::ContactStatus;
use super::friction_work::compute_friction_power;
use super::guard_source;
use super::guards::{Findings, Watch, list_guards};
use super::sample::Quantities;
use super::sampled_step::{SampledStep, Scales};
use super::samples::Samples;
use super::step::StepView;
use super::{Guard, GuardBounds, LOW, StepEvents};
use crate::context::Numbers;
use crate::expression::Condition;
use crate::model::{ContactSet, Layout};
use crate::numerics::root_isolation::{GuardError, NODES};
use smallvec::SmallVec;

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
    /// Of a phase in which the contacts of a set bear; with each condition that is located whether
    /// it arms or disarms.
    pub(crate) fn new(
        layout: &'static Layout,
        set: ContactSet,
        status: ContactStatus<'a>,
        conditions: (&'a [Condition], &[(usize, bool)]),
        bounds: GuardBounds,
    ) -> Self {
        let ContactStatus { forces, slips, .. } = status;
        Self {
            list: list_guards(layout, &set, &status, conditions),
            scales: Scales { bounds, layout, forces, slips, roundings: Numbers::new() },
            samples: RefCell::new(Samples::new(layout)),
            at_rest: None,
            unresolved: None,
            undecided: None,
        }
    }

    /// From now on the guard that was not resolved is taken for noise where it turns too often to
    /// be followed.
    pub(crate) fn expect_noise(&mut self) {
        let noisy = |watch: &&mut Watch<'_>| self.unresolved == Some(watch.tracking.guard);
        self.list.iter_mut().filter(noisy).for_each(|watch| watch.tracking.is_noisy = true);
    }

    /// The power of friction at the nodes of the last step, where all of it is known from the
    /// guards.
    pub(crate) fn friction_powers(&self) -> Option<[f64; NODES.len()]> {
        let (at_rest, samples) = (self.at_rest.as_deref()?, self.samples.borrow());
        let nodes = samples.at_nodes(Quantities::REACTIONS.and(Quantities::SLIPS))?;
        Some(nodes.each_ref().map(|node| compute_friction_power(self.scales.layout, node, at_rest)))
    }

    /// The work of friction over a step up to `end`, where the method has the series of all that it
    /// takes.
    pub(crate) fn friction_work(&self, step: &StepView<'_>, end: f64) -> Option<f64> {
        let Scales { bounds: GuardBounds { relative, .. }, layout, forces, slips, .. } = self.scales;
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

    /// Whether a reaction or gap that touches zero may as well have crossed it: at the touch it
    /// differs from zero by more than rounding, yet by less than its bound.
    pub(crate) fn is_undecided(&self, guard: Guard, reactions: &[f64], gaps: &[f64]) -> bool {
        let watch = self.list.iter().find(|watch| watch.tracking.guard == guard);
        watch.is_some_and(|watch| watch.kind.may_have_crossed(&self.scales, reactions, gaps))
    }

    /// Contacts whose gaps close at a place of a step at which they are seen to be below zero, and
    /// have not been seen to be above since the phase began.
    pub(crate) fn unseen_landings(&self, view: &StepView<'_>, theta: f64, guards: &[Guard]) -> ContactSet {
        let step = &self.sampled(view);
        let landing = |watch: &Watch<'_>| {
            let contact = watch.tracking.guard.gap().filter(|_| watch.tracking.at_root)?;
            let is_below = || watch.value(step, theta) < -0.5 * watch.bound(step, &[]);
            (guards.contains(&watch.tracking.guard) && is_below()).then_some(contact)
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

    /// Marks the guards that are zero at the start of the phase as known roots; `start` is a dense
    /// output at rest there.
    pub(crate) fn begin(&mut self, start: &StepView<'_>) {
        let least = self.least_bound();
        let Self { list, scales, samples, at_rest, .. } = self;
        let known = samples.get_mut();
        let asked = list.iter().fold(Quantities::NONE, |asked, watch| asked.and(watch.tracking.asked));
        if !asked.contains(Quantities::GRIP) {
            *at_rest = start.slips_at_rest(&mut known.scratch);
        }
        if asked != Quantities::NONE {
            known.begin(start, asked);
        }
        if asked.contains(Quantities::GAPS) {
            scales.roundings = start.context.roundings(&known.scratch.state, least);
        }
        let step = &SampledStep { view: start, samples, scales };
        list.iter_mut().for_each(|watch| watch.begin(step));
    }

    /// The height of the lowest flight that the phase begins with; zero if a guard is zero there of
    /// which nothing is known.
    pub(crate) fn lowest_flight(&self) -> f64 {
        let zero = self.list.iter().filter(|watch| watch.tracking.at_root).map(|watch| watch.tracking.height);
        zero.map(|height| if height.is_finite() { height } else { 0.0 }).reduce(f64::min).unwrap_or(0.0)
    }

    /// The least bound of a gap, in its own unit.
    fn least_bound(&self) -> f64 {
        let GuardBounds { relative, length } = self.scales.bounds;
        let lowest = self.list.iter().map(|watch| watch.tracking.height).fold(f64::INFINITY, f64::min);
        relative.min(LOW * lowest / length)
    }

    /// Open contacts that close only after they have come back.
    pub(crate) fn below(&self) -> ContactSet {
        let below = self.list.iter().filter(|watch| watch.kind.is_below());
        below.filter_map(|watch| watch.tracking.guard.contact()).collect()
    }

    /// Everything in (0, 1] up to the first event. On the last step a guard that has fallen to zero
    /// within rounding at its end counts as well: no later step would find it.
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
                    *unresolved = Some(watch.tracking.guard);
                    if !view.is_bridge() {
                        return Err(error);
                    }
                    findings.touches.truncate(known);
                    watch.find_event_in_noise(step, &mut findings)
                }
            };
            let arrival = || (is_last && watch.arrives(step)).then_some(1.0);
            decisive.extend(event.or_else(arrival).map(|theta| (theta, watch.tracking.guard)));
        }
        *undecided = findings.undecided;
        let mut touches = findings.touches;
        let first = decisive.iter().map(|(theta, _)| *theta).min_by(f64::total_cmp);
        touches.retain(|(theta, _)| first.is_none_or(|first| *theta < first));
        touches.sort_by(|a, b| a.0.total_cmp(&b.0));
        let first = first.map(|first| (first, find_together(list, step, first, &decisive)));
        let end = first.as_ref().map_or(1.0, |(theta, _)| theta.min(1.0));
        // No step follows an event, but what seems one across a singular position may be none.
        let is_followed = first.is_none() || view.is_bridge();
        list.iter_mut().for_each(|watch| watch.end_step(step, end, is_followed));
        Ok(StepEvents { touches, first })
    }

    /// Proves of guards by their series that nothing happens to them in a step, as far as they
    /// tell, and evaluates the others at its nodes.
    pub(super) fn begin_step(&mut self, view: &StepView<'_>) {
        let least = self.least_bound();
        let Self { list, scales, samples, .. } = self;
        if let Some(roundings) = view.roundings(least, &mut samples.get_mut().scratch) {
            scales.roundings = roundings;
        }
        let step = &SampledStep { view, samples, scales };
        list.iter_mut().for_each(|watch| watch.begin_step(step));
        samples.get_mut().begin_step(view, list.iter().filter_map(Watch::sampled));
    }
}

/// The decisive guards at `theta`, and all others that are zero within their bound.
fn find_together(
    list: &[Watch<'_>],
    step: &SampledStep<'_>,
    theta: f64,
    decisive: &[(f64, Guard)],
) -> Vec<Guard> {
    let is_together = |watch: &&Watch<'_>| {
        let last = theta + watch.kind.precedence();
        let is_own = |other: &Guard| *other == watch.tracking.guard;
        let is_met = decisive.iter().any(|(at, other)| is_own(other) && (theta..=last).contains(at));
        is_met || !watch.tracking.at_root && !watch.is_above(step, theta) && watch.is_zero(step, theta)
    };
    list.iter().filter(is_together).map(|watch| watch.tracking.guard).collect()
}
