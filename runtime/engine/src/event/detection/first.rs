//! The first event of each kind of guard in a step.

use super::advance::Advance;
use super::guard_source::{self, GuardSource};
use super::{EventDetector, Guard, StepView, Watch};
use crate::numerics::root_isolation::{Crossing, GuardError, Start};

/// Rounding of a gap, relative to the natural length, or to its terms where they are larger.
const ROUNDED: f64 = 16.0 * f64::EPSILON;

impl EventDetector<'_> {
    /// Values of the guards whose series are not known at the nodes of the fit, each function evaluated once for all of
    /// them.
    pub(super) fn sample(&mut self, step: &StepView<'_>) {
        for k in 0..self.list.len() {
            let (guard, limit) = (self.list[k].guard, self.list[k].limit);
            step.write_rubbing(guard, limit, &mut self.list[k].rubbing);
            let watch = &self.list[k];
            let found = watch.series(step).map_or([false; 2], |series| {
                let bound = self.bound(watch, step, &[]);
                [guard_source::is_exact(series, bound), guard_source::is_clear(series, bound)]
            });
            let watch = &mut self.list[k];
            [watch.has_series, watch.is_clear] = found;
            if step.is_fitted() {
                watch.order = None;
            }
        }
        self.known.sample(&self.list, step, self.values.get_mut());
        self.memo.begin(&self.list, step);
    }

    /// The guard over the step, and the bound below which it counts as zero.
    fn trace<'s>(
        &self,
        watch: &'s Watch,
        step: &'s StepView<'_>,
        value: &'s dyn Fn(f64) -> f64,
    ) -> (GuardSource<'s>, f64) {
        let trace = match watch.series(step) {
            Some(series) if watch.has_series => GuardSource::Series(series),
            _ => GuardSource::Values { value, size: self.known.size(watch), is_noisy: watch.is_noisy },
        };
        let bound = self.bound(watch, step, &[]).max(trace.rounding());
        (trace, bound)
    }

    /// The first fall through zero after `from`; zeros that are only touched are added to `touches`.
    pub(super) fn first_downcrossing(
        &self,
        watch: &Watch,
        step: &StepView<'_>,
        from: f64,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<f64>, GuardError> {
        let value = |theta: f64| self.value(step, watch, theta);
        let (trace, bound) = self.trace(watch, step, &value);
        if watch.kept && from == 0.0 && trace.first() < -0.5 * bound {
            // It was kept for a reaction that might as well be zero, which this is not.
            return Ok(Some(0.0));
        }
        let mut from = from;
        let mut start = match watch.order {
            _ if !watch.at_root || from > 0.0 => Start::Free,
            Some(order) => Start::Order(order),
            None => Start::Root,
        };
        let mut advance = Advance::BEGUN;
        loop {
            match trace.watch(from, start, bound)? {
                Crossing::Clear => return Ok(None),
                Crossing::At { theta } => return Ok(Some(theta)),
                Crossing::LeavesAtStart if watch.kept && from == 0.0 => {
                    return self.sinks(watch.guard, &trace, bound);
                }
                Crossing::LeavesAtStart => return Ok(Some(from)),
                Crossing::Touch { theta, .. } => {
                    from = advance.behind(theta, from);
                    touches.push((from, watch.guard));
                    start = Start::Order(2);
                    if from >= 1.0 {
                        return Ok(None);
                    }
                }
            }
        }
    }

    /// Where a guard that was never above its bound falls below it: it has crossed zero somewhere before, and to say so at the start
    /// would stop the time. A limit of friction that is not reached at the start is known better: it is located again.
    fn sinks(&self, guard: Guard, trace: &GuardSource<'_>, bound: f64) -> Result<Option<f64>, GuardError> {
        if matches!(guard, Guard::Limit(_) | Guard::Grip) && trace.first() > 0.0 {
            return trace.first_root(0.0, Start::Free, (0.0, trace.rounding()));
        }
        trace.first_root(0.0, Start::Free, (bound, 0.5 * bound))
    }

    /// The first time that a gap closes with the foot of its corner, if it has one, under the bar. A gap that is
    /// negative beyond the end of the bar is watched again once it has come back, as is one that starts there at zero
    /// and does not come under the bar as it falls.
    pub(super) fn first_closure(
        &self,
        watch: &Watch,
        contact: usize,
        step: &StepView<'_>,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<f64>, GuardError> {
        let value = |theta: f64| self.value(step, watch, theta);
        let (trace, bound) = self.trace(watch, step, &value);
        if self.layout.contacts[contact].kind.is_drive() {
            // What it drives may come from either side.
            let start = match watch.sign {
                _ if watch.at_root => Start::Root,
                Some(positive) => Start::Continues { positive },
                None => Start::Free,
            };
            return trace.first_root(0.0, start, (0.0, bound));
        }
        let mut from = 0.0;
        // Where a gap that never rose above its bound falls below it: the contact has closed somewhere before, and
        // to say so at the start would stop the time.
        let rounding = || {
            let terms = step.terms(contact, &mut self.values.borrow_mut());
            (ROUNDED * terms.max(self.bounds.length)).min(0.5 * bound)
        };
        let sink = || trace.first_root(0.0, Start::Free, (bound, rounding()));
        let is_off = watch.at_root
            && watch.off
            && !sink()?.is_some_and(|theta| self.margin(step, contact, theta) > self.end());
        let mut below =
            if watch.at_root { is_off } else { (watch.passed || watch.off) && trace.first() < -bound };
        let mut advance = Advance::BEGUN;
        while from < 1.0 {
            if below {
                match trace.first_root(from, Start::Root, (0.0, bound))? {
                    Some(theta) => from = theta,
                    None => return Ok(None),
                }
            }
            let mut fall = self.first_downcrossing(watch, step, from, touches)?;
            if fall.is_none() && watch.height.is_finite() && value(1.0) < 0.0 && value(1.0) < -rounding() {
                // The end of a low flight is known much better than to its bound.
                let start = if watch.at_root && from == 0.0 { Start::Root } else { Start::Free };
                fall = trace.first_root(from, start, (0.0, rounding()))?;
            }
            let lands = self.landing(watch, contact, step, fall.unwrap_or(1.0))?;
            let unseen = watch.at_root && !is_off && fall == Some(0.0);
            match if lands.is_some() {
                lands
            } else if unseen {
                sink()?
            } else {
                fall
            } {
                Some(theta) if self.under_bar(step, contact, theta) => return Ok(Some(theta)),
                Some(theta) if theta < 1.0 => {
                    (from, below) = (advance.behind(theta, from), true);
                    watch.passes.set(watch.passes.get().or(Some(theta)));
                }
                _ => return Ok(None),
            }
        }
        Ok(None)
    }
}
