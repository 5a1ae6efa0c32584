//! The integration of the phase that follows.

use super::Driver;
use crate::contact::friction::SharedFriction;
use crate::event::detection::{ContactStatus, EventDetector, GuardBounds, Signals};
use crate::simulation::Simulation;
use crate::simulation::awaited::Role;
use crate::simulation::phase_run::{Limits, PhaseOutcome, PhaseRun, Progress};

/// Order of the first derivative of a gap that does not vanish where its contact opens with its
/// reaction at zero: g = ġ = g̈ = 0 < g⃛.
const LIFTOFF_ORDER: usize = 3;

impl Driver<'_> {
    /// Integrates it, on trial before no observer.
    pub(super) fn integrate(&mut self, is_trial: bool) -> PhaseOutcome {
        let Simulation { context, tolerance, method, rules, parts, cancel, .. } = self.setup;
        let horizon = if self.has_seen_enough() { self.now.t } else { self.now.next_time() };
        let (now, mut nobody) = (&self.now, ());
        let bounds = GuardBounds { relative: now.relative_bound(), length: context.scales.length };
        let orders: Vec<_> = now.onset.opened_at_zero_reaction.iter().map(|i| (i, LIFTOFF_ORDER)).collect();
        let contacts = ContactStatus {
            closed: now.closed(),
            held: now.contacts.held(),
            removed: now.contacts.absent(),
            below: now.contacts.below().union(now.find_beyond_end()),
            suppressed: now.onset.suppressed,
            shared_friction: parts.laws.rough.map_or_else(SharedFriction::default, |rough| {
                (rough.grip)(context.system(), &now.state, &now.closed())
            }),
            heights: &now.find_low_flights(),
            orders: &orders,
            forces: &now.forces(),
            slips: &now.natural_slips(),
        };
        let conditions = &now.awaited.conditions;
        let located =
            |k: &usize| conditions[*k].time(&context.model.parameters).is_none() && now.is_awaited(*k);
        let located: Vec<(usize, bool)> = now
            .awaited
            .places()
            .filter(located)
            .map(|k| (k, matches!(now.awaited.role(k), Role::Switch { .. })))
            .collect();
        let located = (&conditions[..], &located[..]);
        let detector = EventDetector::new(now.layout(), now.active_basis(), contacts, located, bounds);
        let run = PhaseRun {
            context,
            phase: now.phase.clone(),
            closed: now.closed(),
            detector,
            signals: Signals::new(now.layout(), &rules.signals, &context.model.parameters),
            tolerance: *tolerance,
            t: now.t,
            horizon,
            state: now.state.clone(),
            progress: Progress::default(),
            observer: if is_trial { &mut nobody } else { &mut *self.observer },
            affine: Some(&mut self.affine),
            parts: *parts,
            limits: Limits { cancel: cancel.as_deref(), allowance: self.allowance },
        };
        run.run(&**method)
    }
}
