//! The first event of each kind of guard in a step.

use super::{Guard, StepView, Watch, Watches};
use crate::guard::{self, NODES, NotFinite, Start, Verdict};
use crate::model::{BarSystem, KernelView};
use crate::output::Relation;

/// The search of a step goes on at least so far behind an event that does not count, twice as far each time: within
/// rounding of a zero it would find the same one for ever.
const LEAST_ADVANCE: f64 = f64::EPSILON;

impl Watches<'_> {
    /// Values of all guards but the conditions at the nodes of the fit, each function evaluated once for all of them.
    pub(super) fn sample<M: BarSystem, const N: usize>(&mut self, step: &StepView<'_, M, N>) {
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
                    Guard::Condition(_) => None,
                };
                watch.samples[j] = value.unwrap_or(f64::NAN);
            }
        }
    }

    /// The first fall through zero after `from`; zeros that are only touched are added to `touches`.
    pub(super) fn fall<M: BarSystem, const N: usize>(
        &self,
        watch: &Watch,
        step: &StepView<'_, M, N>,
        from: f64,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<f64>, NotFinite> {
        let bound = self.bound::<M, N>(watch, &[]).max(rounding(&watch.samples));
        let mut from = from;
        let mut start = if watch.at_root && from == 0.0 { Start::Root } else { Start::Free };
        let mut least = LEAST_ADVANCE;
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
                    from = at(theta).max(from + least);
                    least *= 2.0;
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
    /// negative beyond the end of the bar is watched again once it has come back, as is one that starts there at zero.
    pub(super) fn closing<M: BarSystem, const N: usize>(
        &self,
        watch: &Watch,
        contact: usize,
        step: &StepView<'_, M, N>,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<f64>, NotFinite> {
        let bound = self.bound::<M, N>(watch, &[]).max(rounding(&watch.samples));
        let mut from = 0.0;
        let has_end = M::LAYOUT.contacts[contact].foot.is_some();
        let mut below = if watch.at_root { watch.off } else { has_end && watch.samples[0] < -bound };
        let mut least = LEAST_ADVANCE;
        while from < 1.0 {
            if below {
                let value = |s: f64| step.at(from + (1.0 - from) * s).value(self.conditions, watch.guard);
                match guard::first_root(value, Start::Root, bound)? {
                    Some(s) => from += (1.0 - from) * s,
                    None => return Ok(None),
                }
            }
            let fall = self.fall(watch, step, from, touches)?;
            let unseen = watch.at_root && !watch.off && fall == Some(0.0);
            match if unseen { self.sink(watch, step, bound)? } else { fall } {
                Some(theta) if step.at(theta).under_bar(contact, self.bounds) => return Ok(Some(theta)),
                Some(theta) if theta < 1.0 => (from, below) = (theta.max(from + least), true),
                _ => return Ok(None),
            }
            least *= 2.0;
        }
        Ok(None)
    }

    /// Where a gap that never rose above its bound falls below it: the contact has closed somewhere before, and to say
    /// so at the start would stop the time.
    fn sink<M: BarSystem, const N: usize>(
        &self,
        watch: &Watch,
        step: &StepView<'_, M, N>,
        bound: f64,
    ) -> Result<Option<f64>, NotFinite> {
        let depth = |theta: f64| step.at(theta).value(self.conditions, watch.guard) + bound;
        guard::first_root(depth, Start::Free, 0.0)
    }

    pub(super) fn condition<M: BarSystem, const N: usize>(
        &self,
        watch: &Watch,
        k: usize,
        step: &StepView<'_, M, N>,
    ) -> Result<Option<f64>, NotFinite> {
        let bound = self.bound(watch, &[&step.at(0.0), &step.at(0.5), &step.at(1.0)]);
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
}

/// Of a value that is a difference of terms of the size of the samples.
fn rounding(samples: &[f64]) -> f64 {
    16.0 * f64::EPSILON * samples.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
}
