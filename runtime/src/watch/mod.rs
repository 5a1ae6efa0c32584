//! The guards of a phase over one step: reactions of closed contacts, gaps of open ones, feet of closed corners, and
//! the conditions that are waited for.

mod first;
mod step;

pub(crate) use step::StepView;

use crate::guard::{NODES, NotFinite, Samples};
use crate::model::{BarSystem, ContactSet, Phase};
use crate::moment::Scene;
use crate::output::Condition;
use step::Instant;

/// The part of a flight's height that counts as zero.
const LOW: f64 = 1.0 / 64.0;

/// What is watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Guard {
    /// The reaction of a closed contact.
    Reaction(usize),
    /// The gap of an open contact.
    Gap(usize),
    /// An entry of the model's feet, with its contact.
    Foot { contact: usize, entry: usize },
    /// A condition that ends the run or starts something planned.
    Condition(usize),
}

/// Error bounds of the guards, relative to natural scales and in their units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds {
    pub(crate) relative: f64,
    pub(crate) force: f64,
    pub(crate) length: f64,
}

/// What a step brings.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    /// Guards that touch zero, before the first event.
    pub(crate) touches: Vec<(f64, Guard)>,
    /// The first event, and all guards that are within their bound of zero there.
    pub(crate) first: Option<(f64, Vec<Guard>)>,
}

struct Watch {
    guard: Guard,
    /// What counts as zero, where that is less than for its kind: a flight that does not rise so high.
    height: Option<f64>,
    /// A corner beyond the end of its bar, which does not close before it has come back.
    off: bool,
    /// Its value has not left its bound since the phase began with it at zero.
    at_root: bool,
    samples: Samples,
}

/// All guards of a phase.
pub(crate) struct Watches<'a> {
    list: Vec<Watch>,
    conditions: &'a [Condition],
    bounds: Bounds,
}

/// Contacts as the run treats them.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Roles<'a> {
    pub(crate) held: ContactSet,
    pub(crate) removed: ContactSet,
    /// Open contacts whose foot is not under the bar.
    pub(crate) off: ContactSet,
    /// Heights that bouncing contacts are to reach.
    pub(crate) heights: &'a [(usize, f64)],
}

impl<'a> Watches<'a> {
    pub(crate) fn new<M: BarSystem>(
        set: ContactSet,
        roles: Roles,
        (conditions, located): (&'a [Condition], &[usize]),
        bounds: Bounds,
    ) -> Self {
        let mut guards = Vec::new();
        for (contact, layout) in M::LAYOUT.contacts.iter().enumerate() {
            if !set.contains(contact) {
                guards.extend((!roles.removed.contains(contact)).then_some(Guard::Gap(contact)));
                continue;
            }
            guards.extend((!roles.held.contains(contact)).then_some(Guard::Reaction(contact)));
            if let Some(foot) = layout.foot {
                guards.extend([2 * foot, 2 * foot + 1].map(|entry| Guard::Foot { contact, entry }));
            }
        }
        guards.extend(located.iter().map(|&k| Guard::Condition(k)));
        let watch = |guard| {
            let contact = if let Guard::Gap(i) = guard { Some(i) } else { None };
            let height = contact.and_then(|i| roles.heights.iter().find(|(k, _)| *k == i));
            Watch {
                guard,
                height: height.map(|(_, height)| *height),
                off: contact.is_some_and(|i| roles.off.contains(i)),
                at_root: false,
                samples: [f64::NAN; NODES.len()],
            }
        };
        Self { list: guards.into_iter().map(watch).collect(), conditions, bounds }
    }

    /// Takes the guards that are zero at the start of the phase for known roots.
    pub(crate) fn begin<M: BarSystem, const N: usize>(
        &mut self,
        phase: &Phase<M, f64, N>,
        scene: &Scene<M>,
        t: f64,
        start: &[f64; N],
    ) {
        let at = Instant { phase, scene, t, reduced: *start };
        for k in 0..self.list.len() {
            let value = at.value(self.conditions, self.list[k].guard);
            if let Some(height) = &mut self.list[k].height {
                // A flight that begins so deep has its ground there.
                *height = height.max(2.0 * (-value).max(0.0) / LOW);
            }
            self.list[k].at_root = value.abs() <= self.bound(&self.list[k], &[&at]);
        }
    }

    /// Everything in (0, 1] up to the first event.
    pub(crate) fn examine<M: BarSystem, const N: usize>(
        &mut self,
        step: &StepView<'_, M, N>,
    ) -> Result<Findings, NotFinite> {
        self.sample(step);
        let mut findings = Findings::default();
        let mut decisive = Vec::new();
        for watch in &self.list {
            let event = match watch.guard {
                Guard::Condition(k) => self.condition(watch, k, step)?,
                Guard::Gap(contact) => self.closing(watch, contact, step, &mut findings.touches)?,
                Guard::Reaction(_) | Guard::Foot { .. } => {
                    self.fall(watch, step, 0.0, &mut findings.touches)?
                }
            };
            decisive.extend(event.map(|theta| (theta, watch.guard)));
        }
        if let Some(first) = decisive.iter().map(|(theta, _)| *theta).min_by(f64::total_cmp) {
            findings.touches.retain(|(theta, _)| *theta < first);
            findings.first = Some((first, self.together(step, first, &decisive)));
        }
        findings.touches.sort_by(|a, b| a.0.total_cmp(&b.0));
        self.leave_roots(step);
        Ok(findings)
    }

    /// The decisive guards at `theta`, and all others that are zero within their bound.
    fn together<M: BarSystem, const N: usize>(
        &self,
        step: &StepView<'_, M, N>,
        theta: f64,
        decisive: &[(f64, Guard)],
    ) -> Vec<Guard> {
        let at = step.at(theta);
        let zero = |watch: &&Watch| {
            decisive.contains(&(theta, watch.guard))
                || !watch.at_root && at.value(self.conditions, watch.guard).abs() <= self.bound(watch, &[&at])
        };
        self.list.iter().filter(zero).map(|watch| watch.guard).collect()
    }

    fn leave_roots<M: BarSystem, const N: usize>(&mut self, step: &StepView<'_, M, N>) {
        let at = step.at(1.0);
        for k in 0..self.list.len() {
            let watch = &self.list[k];
            if watch.at_root {
                let zero = at.value(self.conditions, watch.guard).abs() <= self.bound(watch, &[&at]);
                self.list[k].at_root = zero;
            }
        }
    }

    /// What counts as zero; for conditions relative to the larger side at the given times.
    fn bound<M: BarSystem, const N: usize>(&self, watch: &Watch, at: &[&Instant<'_, M, N>]) -> f64 {
        let usual = self.bounds.relative
            * match watch.guard {
                Guard::Reaction(_) => self.bounds.force,
                Guard::Gap(_) | Guard::Foot { .. } => self.bounds.length,
                Guard::Condition(k) => {
                    at.iter().fold(0.0, |most: f64, at| most.max(at.difference(&self.conditions[k]).1))
                }
            };
        watch.height.map_or(usual, |height| usual.min(height * LOW))
    }
}
