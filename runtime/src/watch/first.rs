//! The first event of each kind of guard in a step.

use super::step::Kinds;
use super::{Guard, Motion, Watch, Watches};
use crate::guard::{self, NODES, NotFinite, Start, Verdict};
use crate::output::Relation;

/// The search of a step goes on at least so far behind an event that does not count, twice as far each time: within
/// rounding of a zero it would find the same one for ever.
const LEAST_ADVANCE: f64 = f64::EPSILON;

impl Watches<'_> {
    /// Values of all guards but the conditions at the nodes of the fit, each function evaluated once for all of them.
    pub(super) fn sample(&mut self, step: &dyn Motion) {
        let kinds = Kinds::of(self.list.iter().map(|watch| watch.guard));
        if !kinds.any() {
            return;
        }
        let values = self.values.get_mut();
        for (j, &theta) in NODES.iter().enumerate() {
            step.sample(theta, kinds, values);
            for watch in &mut self.list {
                watch.samples[j] = values.get(watch.guard);
            }
        }
    }

    /// The first fall through zero after `from`; zeros that are only touched are added to `touches`.
    pub(super) fn fall(
        &self,
        watch: &Watch,
        step: &dyn Motion,
        from: f64,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<f64>, NotFinite> {
        let bound = self.bound(watch, step, &[]).max(rounding(&watch.samples));
        let mut from = from;
        let mut start = if watch.at_root && from == 0.0 { Start::Root } else { Start::Free };
        let mut least = LEAST_ADVANCE;
        loop {
            let at = |s: f64| from + (1.0 - from) * s;
            let value = |s: f64| self.value(step, watch.guard, at(s));
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
    pub(super) fn closing(
        &self,
        watch: &Watch,
        contact: usize,
        step: &dyn Motion,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<f64>, NotFinite> {
        let bound = self.bound(watch, step, &[]).max(rounding(&watch.samples));
        let mut from = 0.0;
        let has_end = self.layout.contacts[contact].foot.is_some();
        let mut below = if watch.at_root { watch.off } else { has_end && watch.samples[0] < -bound };
        let mut least = LEAST_ADVANCE;
        while from < 1.0 {
            if below {
                let value = |s: f64| self.value(step, watch.guard, from + (1.0 - from) * s);
                match guard::first_root(value, Start::Root, bound)? {
                    Some(s) => from += (1.0 - from) * s,
                    None => return Ok(None),
                }
            }
            let fall = self.fall(watch, step, from, touches)?;
            let unseen = watch.at_root && !watch.off && fall == Some(0.0);
            match if unseen { self.sink(watch, step, bound)? } else { fall } {
                Some(theta) if self.under_bar(step, contact, theta) => return Ok(Some(theta)),
                Some(theta) if theta < 1.0 => (from, below) = (theta.max(from + least), true),
                _ => return Ok(None),
            }
            least *= 2.0;
        }
        Ok(None)
    }

    /// Where a gap that never rose above its bound falls below it: the contact has closed somewhere before, and to say
    /// so at the start would stop the time.
    fn sink(&self, watch: &Watch, step: &dyn Motion, bound: f64) -> Result<Option<f64>, NotFinite> {
        let depth = |theta: f64| self.value(step, watch.guard, theta) + bound;
        guard::first_root(depth, Start::Free, 0.0)
    }

    pub(super) fn condition(
        &self,
        watch: &Watch,
        k: usize,
        step: &dyn Motion,
    ) -> Result<Option<f64>, NotFinite> {
        let bound = self.bound(watch, step, &[0.0, 0.5, 1.0]);
        let start = if watch.at_root { Start::Root } else { Start::Free };
        let value = |theta: f64| self.value(step, watch.guard, theta);
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
