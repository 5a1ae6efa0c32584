//! What of a guard counts as zero, and which guards are zero together.

use super::guard_source::EXACT;
use super::step::Kinds;
use super::{EventDetector, Guard, LOW, StepView, Watch};
use crate::expression::Relation;
use smallvec::SmallVec;

/// The fraction of a run's last step over which a guard must fall to count as zero at its end.
const LAST: f64 = 1.0 / 64.0;

/// An equation is met at an event that precedes its root by this part of the step: both may be about the same quantity, which the
/// event then keeps at zero, located by different means.
const TOGETHER: f64 = 1e-12;

/// A reaction that touches zero to within this fraction of its bound is known not to cross it.
const CERTAIN: f64 = 1.0 / 64.0;

impl EventDetector<'_> {
    /// Whether a reaction or gap that touches zero may as well have crossed it: at the touch it differs from zero by more than
    /// rounding, yet by less than its bound.
    pub(crate) fn is_undecided(&self, guard: Guard, reactions: &[f64], gaps: &[f64]) -> bool {
        let (value, size) = match guard {
            Guard::Reaction(i) | Guard::Side(i, _) => (reactions[i], self.forces[i]),
            Guard::Gap(i) => (gaps[i], self.size_of_gap(i)),
            Guard::Parting(_)
            | Guard::Foot { .. }
            | Guard::Limit(_)
            | Guard::Grip
            | Guard::Slip(_)
            | Guard::Condition(_) => return false,
        };
        value.abs() > CERTAIN * self.bounds.relative * size
    }

    /// Whether a reaction or gap has fallen into its bound at the end of the step, and not with a turning point there:
    /// it falls by as much as before.
    pub(super) fn arrives(&self, watch: &Watch, step: &StepView<'_>) -> bool {
        if watch.is_clear {
            return false;
        }
        let [before, near, end] =
            [1.0 - 2.0 * LAST, 1.0 - LAST, 1.0].map(|theta| self.value(step, watch, theta));
        let bound = self.bound(watch, step, &[]);
        let falls = near - end > bound && near - end > 0.75 * (before - near);
        let is_condition = matches!(watch.guard, Guard::Condition(_));
        let under = |contact| self.under_bar(step, contact, 1.0);
        let met = match watch.guard {
            Guard::Gap(contact) => under(contact),
            Guard::Reaction(_)
            | Guard::Side(..)
            | Guard::Parting(_)
            | Guard::Foot { .. }
            | Guard::Limit(_)
            | Guard::Grip
            | Guard::Slip(_)
            | Guard::Condition(_) => true,
        };
        !is_condition && !watch.at_root && end.abs() <= bound && falls && met
    }

    /// The decisive guards at `theta`, and all others that are zero within their bound.
    pub(super) fn together(&self, step: &StepView<'_>, theta: f64, decisive: &[(f64, Guard)]) -> Vec<Guard> {
        let is_equation = |watch: &Watch| matches!(watch.guard, Guard::Condition(k) if self.conditions[k].relation() == Relation::Equal);
        let is_met = |watch: &Watch| {
            let last = if is_equation(watch) { theta + TOGETHER } else { theta };
            decisive.iter().any(|(at, guard)| *guard == watch.guard && (theta..=last).contains(at))
        };
        let is_zero = |watch: &Watch| !self.is_above(watch, step, theta) && self.is_zero(watch, step, theta);
        let zero = |watch: &&Watch| is_met(watch) || !watch.at_root && is_zero(watch);
        self.list.iter().filter(zero).map(|watch| watch.guard).collect()
    }

    /// Whether a guard is within its bound.
    pub(super) fn is_zero(&self, watch: &Watch, step: &StepView<'_>, theta: f64) -> bool {
        self.value(step, watch, theta).abs() <= self.bound(watch, step, &[theta])
    }

    /// What counts as zero; for conditions relative to the larger side, as most of the given times have it: beside a pole it is
    /// of any size.
    pub(super) fn bound(&self, watch: &Watch, step: &StepView<'_>, at: &[f64]) -> f64 {
        let usual = self.bounds.relative
            * match watch.guard {
                Guard::Reaction(i) | Guard::Side(i, _) => self.forces[i],
                Guard::Limit(rub) => self.forces[rub.contact],
                Guard::Grip => self.forces.iter().copied().fold(0.0, f64::max),
                Guard::Slip(rub) => self.slips[rub.friction],
                Guard::Gap(i) | Guard::Parting(i) => self.size_of_gap(i),
                Guard::Foot { .. } => self.bounds.length,
                Guard::Condition(k) => {
                    let size = |&theta: &f64| {
                        step.difference(theta, &self.conditions[k], &mut self.values.borrow_mut()).1
                    };
                    let least = self.rounding(k, step, at) / self.bounds.relative;
                    middle(at.iter().map(size).collect()).map_or(least, |size| size.max(least))
                }
            };
        usual.min(watch.height * LOW)
    }

    /// The least bound of a gap, in its own unit.
    pub(super) fn least_bound(&self) -> f64 {
        let low = self.list.iter().fold(f64::INFINITY, |low, watch| low.min(watch.height));
        self.bounds.relative.min(LOW * low / self.bounds.length)
    }

    /// The unit of a gap, or that of which the relative bound is its rounding.
    fn size_of_gap(&self, contact: usize) -> f64 {
        let rounding = self.roundings.get(contact).map_or(0.0, |rounding| rounding / self.bounds.relative);
        self.layout.unit(contact, self.bounds.length) * rounding.max(1.0)
    }

    /// Whether the difference of a condition's sides counts as zero at the start of a phase.
    pub(super) fn is_met_at_start(&self, k: usize, start: &StepView<'_>) -> bool {
        let (value, size) = start.difference(0.0, &self.conditions[k], &mut self.values.borrow_mut());
        value.abs() <= self.bounds.relative * size || value.abs() <= self.rounding(k, start, &[0.0])
    }

    /// The least rounding of a condition at the given times: it grows beyond all bounds towards poles.
    pub(super) fn rounding(&self, k: usize, step: &StepView<'_>, at: &[f64]) -> f64 {
        let values = &self.values;
        let each =
            at.iter().map(|&theta| step.rounding(theta, &self.conditions[k], &mut values.borrow_mut()));
        each.reduce(f64::min).unwrap_or(0.0)
    }

    pub(super) fn value(&self, step: &StepView<'_>, watch: &Watch, theta: f64) -> f64 {
        let mut values = self.values.borrow_mut();
        if let Guard::Condition(k) = watch.guard {
            return step.difference(theta, &self.conditions[k], &mut values).0;
        }
        let known = self.known.get(watch, theta);
        known.or_else(|| self.memo.value((&self.list, watch), (step, theta), &mut values)).unwrap_or_else(
            || {
                step.sample(theta, Kinds::of([watch.guard]), &mut values);
                values.get(watch.guard)
            },
        )
    }

    /// Whether the series of a guard tells that it is above its bound, however much of that its error takes.
    pub(super) fn is_above(&self, watch: &Watch, step: &StepView<'_>, theta: f64) -> bool {
        if watch.is_clear {
            return true;
        }
        let series = watch.series(step).filter(|_| watch.has_series);
        let at = |c: &[f64]| c.iter().rev().fold(0.0, |sum, c| sum * theta + c);
        series.is_some_and(|c| at(c) > (1.0 + EXACT) * self.bound(watch, step, &[]))
    }

    /// Whether the foot of a contact is under its bar, if it has one.
    pub(super) fn under_bar(&self, step: &StepView<'_>, contact: usize, theta: f64) -> bool {
        self.margin(step, contact, theta) >= -self.end()
    }

    /// How far the foot of a contact is from the nearer end of its bar, infinite if it has none.
    pub(super) fn margin(&self, step: &StepView<'_>, contact: usize, theta: f64) -> f64 {
        let Some(foot) = self.layout.contacts[contact].foot else { return f64::INFINITY };
        let mut values = self.values.borrow_mut();
        step.sample(theta, Kinds { feet: true, ..Kinds::default() }, &mut values);
        values.margins(foot).into_iter().fold(f64::INFINITY, f64::min)
    }

    /// How near a foot to the end of its bar is at the end.
    pub(super) fn end(&self) -> f64 {
        self.bounds.relative * self.bounds.length
    }
}

/// The one in the middle, the greater of two.
fn middle(mut sizes: SmallVec<[f64; 4]>) -> Option<f64> {
    sizes.sort_unstable_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied()
}
