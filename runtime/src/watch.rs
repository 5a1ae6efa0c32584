//! The guards of a phase over one step: reactions of closed contacts, gaps of open ones, feet of closed corners, and
//! the conditions that end the run.

use crate::guard::{self, NODES, NotFinite, Samples, Start, Verdict};
use crate::integrate::Interpolant;
use crate::model::{BarSystem, ContactSet, KernelView, Phase};
use crate::moment::{At, Scene};
use crate::output::{Condition, Relation};

/// What is watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Guard {
    /// The reaction of a closed contact.
    Reaction(usize),
    /// The gap of an open contact.
    Gap(usize),
    /// An entry of the model's feet, with its contact.
    Foot { contact: usize, entry: usize },
    /// A condition.
    Stop(usize),
}

/// A step of a phase.
pub(crate) struct StepView<'a, M: BarSystem, const N: usize> {
    pub(crate) phase: &'a Phase<M, f64, N>,
    pub(crate) scene: &'a Scene<M>,
    pub(crate) dense: &'a Interpolant<f64, N>,
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
pub(crate) struct Roles {
    pub(crate) held: ContactSet,
    pub(crate) removed: ContactSet,
}

impl<'a> Watches<'a> {
    pub(crate) fn new<M: BarSystem>(
        set: ContactSet,
        roles: Roles,
        conditions: &'a [Condition],
        parameters: &[f64],
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
        let located = (0..conditions.len()).filter(|&k| conditions[k].time(parameters).is_none());
        guards.extend(located.map(Guard::Stop));
        let watch = |guard| Watch { guard, at_root: false, samples: [f64::NAN; NODES.len()] };
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
            let guard = self.list[k].guard;
            self.list[k].at_root = at.value(self.conditions, guard).abs() <= self.bound(guard, &[&at]);
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
                Guard::Stop(k) => self.stop(watch, k, step)?,
                Guard::Gap(contact) => self.closing(watch, contact, step, &mut findings.touches)?,
                Guard::Reaction(_) | Guard::Foot { .. } => self.fall(watch, step, 0.0, &mut findings.touches)?,
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

    fn sample<M: BarSystem, const N: usize>(&mut self, step: &StepView<'_, M, N>) {
        let any = |kind: fn(Guard) -> bool| self.list.iter().any(|watch| kind(watch.guard));
        let reactions = any(|guard| matches!(guard, Guard::Reaction(_)));
        let gaps = any(|guard| matches!(guard, Guard::Gap(_)));
        let feet = any(|guard| matches!(guard, Guard::Foot { .. }));
        if !(reactions || gaps || feet) {
            return;
        }
        let constants = &step.scene.constants;
        for (j, &theta) in NODES.iter().enumerate() {
            let reduced = step.dense.at(theta);
            let state = (step.phase.embed)(constants, &reduced);
            let reactions = reactions.then(|| (step.phase.reactions)(constants, step.phase.set, &reduced));
            let kernel = gaps.then(|| M::kernel(constants, &state));
            let feet = feet.then(|| M::feet(constants, &state));
            for watch in &mut self.list {
                let value = match watch.guard {
                    Guard::Reaction(i) => reactions.as_ref().map(|reactions| reactions.as_ref()[i]),
                    Guard::Gap(i) => kernel.as_ref().map(|kernel| kernel.gap()[i]),
                    Guard::Foot { entry, .. } => feet.as_ref().map(|feet| feet.as_ref()[entry]),
                    Guard::Stop(_) => None,
                };
                watch.samples[j] = value.unwrap_or(f64::NAN);
            }
        }
    }

    /// The first fall through zero after `from`; zeros that are only touched are added to `touches`.
    fn fall<M: BarSystem, const N: usize>(
        &self,
        watch: &Watch,
        step: &StepView<'_, M, N>,
        from: f64,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<f64>, NotFinite> {
        let bound = self.bound::<M, N>(watch.guard, &[]);
        let mut from = from;
        let mut start = if watch.at_root && from == 0.0 { Start::Root } else { Start::Free };
        loop {
            let at = |s: f64| from + (1.0 - from) * s;
            let value = |s: f64| step.at(at(s)).value(self.conditions, watch.guard);
            let verdict = if from == 0.0 {
                guard::watch_sampled(&watch.samples, value, start, bound)?
            } else {
                guard::watch(value, start, bound)?
            };
            match verdict {
                Verdict::Clear => return Ok(None),
                Verdict::Crossing { theta } => return Ok(Some(at(theta))),
                Verdict::LeavesAtStart => return Ok(Some(from)),
                Verdict::Touch { theta, .. } => {
                    from = at(theta);
                    touches.push((from, watch.guard));
                    start = Start::Root;
                    if from >= 1.0 {
                        return Ok(None);
                    }
                }
            }
        }
    }

    /// The first time that a gap closes with the foot of its corner, if it has one, under the bar. A gap that is
    /// negative beyond the end of the bar is watched again once it has come back.
    fn closing<M: BarSystem, const N: usize>(
        &self,
        watch: &Watch,
        contact: usize,
        step: &StepView<'_, M, N>,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<f64>, NotFinite> {
        let bound = self.bound::<M, N>(watch.guard, &[]);
        let mut from = 0.0;
        let mut below = !watch.at_root && watch.samples[0] < -bound;
        loop {
            if below {
                let value = |s: f64| step.at(from + (1.0 - from) * s).value(self.conditions, watch.guard);
                match guard::first_root(value, Start::Root, bound)? {
                    Some(s) => from += (1.0 - from) * s,
                    None => return Ok(None),
                }
            }
            match self.fall(watch, step, from, touches)? {
                Some(theta) if step.at(theta).under_bar(contact, self.bounds) => return Ok(Some(theta)),
                Some(theta) if theta < 1.0 => (from, below) = (theta, true),
                _ => return Ok(None),
            }
        }
    }

    fn stop<M: BarSystem, const N: usize>(
        &self,
        watch: &Watch,
        k: usize,
        step: &StepView<'_, M, N>,
    ) -> Result<Option<f64>, NotFinite> {
        let bound = self.bound(watch.guard, &[&step.at(0.0), &step.at(0.5), &step.at(1.0)]);
        let start = if watch.at_root { Start::Root } else { Start::Free };
        let value = |theta: f64| step.at(theta).value(self.conditions, watch.guard);
        let verdict = match self.conditions[k].relation() {
            Relation::Equal => return guard::first_root(value, start, bound),
            Relation::Less => guard::watch(value, start, bound)?,
            Relation::Greater => guard::watch(|theta| -value(theta), start, bound)?,
        };
        Ok(match verdict {
            Verdict::Crossing { theta } => Some(theta),
            Verdict::LeavesAtStart if watch.at_root => Some(0.0),
            _ => None,
        })
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
                || !watch.at_root && at.value(self.conditions, watch.guard).abs() <= self.bound(watch.guard, &[&at])
        };
        self.list.iter().filter(zero).map(|watch| watch.guard).collect()
    }

    fn leave_roots<M: BarSystem, const N: usize>(&mut self, step: &StepView<'_, M, N>) {
        let at = step.at(1.0);
        for k in 0..self.list.len() {
            let guard = self.list[k].guard;
            if self.list[k].at_root {
                self.list[k].at_root = at.value(self.conditions, guard).abs() <= self.bound(guard, &[&at]);
            }
        }
    }

    /// What counts as zero; for conditions relative to the larger side at the given times.
    fn bound<M: BarSystem, const N: usize>(&self, guard: Guard, at: &[&Instant<'_, M, N>]) -> f64 {
        self.bounds.relative
            * match guard {
                Guard::Reaction(_) => self.bounds.force,
                Guard::Gap(_) | Guard::Foot { .. } => self.bounds.length,
                Guard::Stop(k) => at.iter().fold(0.0, |most: f64, at| most.max(at.difference(&self.conditions[k]).1)),
            }
    }
}

/// A time of a phase.
pub(crate) struct Instant<'a, M: BarSystem, const N: usize> {
    phase: &'a Phase<M, f64, N>,
    scene: &'a Scene<M>,
    t: f64,
    reduced: [f64; N],
}

impl<M: BarSystem, const N: usize> StepView<'_, M, N> {
    fn at(&self, theta: f64) -> Instant<'_, M, N> {
        let t = self.dense.t0 + theta * self.dense.h;
        Instant { phase: self.phase, scene: self.scene, t, reduced: self.dense.at(theta) }
    }
}

impl<M: BarSystem, const N: usize> Instant<'_, M, N> {
    fn value(&self, conditions: &[Condition], guard: Guard) -> f64 {
        let constants = &self.scene.constants;
        let state = || (self.phase.embed)(constants, &self.reduced);
        match guard {
            Guard::Reaction(i) => (self.phase.reactions)(constants, self.phase.set, &self.reduced).as_ref()[i],
            Guard::Gap(i) => M::kernel(constants, &state()).gap()[i],
            Guard::Foot { entry, .. } => M::feet(constants, &state()).as_ref()[entry],
            Guard::Stop(k) => self.difference(&conditions[k]).0,
        }
    }

    fn difference(&self, condition: &Condition) -> (f64, f64) {
        let moment = At::new(self.phase, &self.scene.constants, self.t, self.reduced);
        condition.difference(self.scene, &moment)
    }

    fn under_bar(&self, contact: usize, bounds: Bounds) -> bool {
        let Some(foot) = M::LAYOUT.contacts[contact].foot else { return true };
        let constants = &self.scene.constants;
        let feet = M::feet(constants, &(self.phase.embed)(constants, &self.reduced));
        feet.as_ref()[2 * foot..2 * foot + 2].iter().all(|margin| *margin >= -bounds.relative * bounds.length)
    }
}
