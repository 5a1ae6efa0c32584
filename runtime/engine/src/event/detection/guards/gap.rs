//! The gap of an open contact, with the foot of its corner if it has one.

use super::low_flight::LowFlight;
use super::watch::{Findings, Kind, Tracking, Watch};
use crate::event::detection::Guard;
use crate::event::detection::advance::Advance;
use crate::event::detection::contact_status::ContactStatus;
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::{SampledStep, Scales};
use crate::event::detection::step::StepView;
use crate::numerics::root_isolation::{GuardError, RootStart};
use crate::numerics::zero::roundoff;

/// g of a contact that closes by falling.
pub(super) struct GapGuard {
    contact: usize,
    /// The foot of its corner.
    foot: Option<usize>,
    /// Where in the step it is below from: it closes only after it has come back. That is at the
    /// start, or where it has fallen beyond the end of its bar.
    below: Option<f64>,
    /// If it is zero at the start of the phase, the order of its first nonzero derivative.
    order: Option<usize>,
    /// Since it has lifted off with its reaction at zero, while it is low.
    flight: Option<LowFlight>,
}

impl GapGuard {
    fn new(contact: usize, foot: Option<usize>, status: &ContactStatus<'_>) -> Self {
        let order = status.orders.iter().find(|(known, _)| *known == contact).map(|(_, order)| *order);
        Self {
            contact,
            foot,
            below: status.below.contains(contact).then_some(0.0),
            order,
            flight: order.and_then(LowFlight::begin),
        }
    }

    pub(super) fn watch<'a>(contact: usize, foot: Option<usize>, status: &ContactStatus<'_>) -> Watch<'a> {
        let mut watch = Watch::new(Guard::Gap(contact), Quantities::GAPS, Self::new(contact, foot, status));
        watch.tracking.height = status.height(contact);
        watch
    }

    /// The first time that it closes with the foot of its corner, if it has one, under the bar. One
    /// that is below is watched again once it has come back, as is one that starts at zero beyond
    /// the end of the bar and does not come under the bar as it falls.
    fn find_closure(
        &mut self,
        tracking: &Tracking,
        step: &SampledStep<'_>,
        findings: &mut Findings,
    ) -> Result<Option<f64>, GuardError> {
        let contact = self.contact;
        let value = |theta: f64| step.gap(contact, theta);
        let (source, bound) = tracking.trace(self, step, &value);
        // Where a gap that never rose above its bound falls below it: the contact has closed
        // somewhere before, and to say so at the start would stop the time.
        let rounding = || {
            let terms = step.evaluate(|view, scratch| view.terms(contact, scratch));
            (roundoff(16.0) * terms.max(step.scales.layout.unit(contact, step.scales.bounds.length)))
                .min(0.5 * bound)
        };
        let sink = || source.first_root(0.0, RootStart::Free, (bound, rounding()));
        let is_below = self.below == Some(0.0)
            && match tracking.at_root {
                true => !sink()?.is_some_and(|theta| step.margin(self.foot, theta) > step.scales.end()),
                false => source.first() < -bound,
            };
        self.below = is_below.then_some(0.0);
        let (mut from, mut below, mut advance) = (0.0, is_below, Advance::BEGUN);
        while from < 1.0 {
            if below {
                match source.first_root(from, RootStart::Root, (0.0, bound))? {
                    Some(theta) => from = theta,
                    None => return Ok(None),
                }
            }
            let start = if from > 0.0 { RootStart::Free } else { tracking.start() };
            let known = self.order.filter(|_| start == RootStart::Root).map_or(start, RootStart::Order);
            let touch = &mut |theta| findings.touches.push((theta, tracking.guard));
            let mut fall = source.find_fall(bound, (from, known), Suppression::None, touch)?;
            let is_low = tracking.height.is_finite();
            if fall.is_none() && is_low && value(1.0) < 0.0 && value(1.0) < -rounding() {
                // The end of a low flight is known much better than to its bound.
                fall = source.first_root(from, start, (0.0, rounding()))?;
            }
            let landing =
                |flight: &LowFlight| flight.find_landing(contact, step, (&value, fall.unwrap_or(1.0)));
            let lands = self.flight.as_ref().map_or(Ok(None), landing)?;
            let is_unseen = tracking.at_root && !is_below && fall == Some(0.0);
            match if lands.is_none() && is_unseen { sink()? } else { lands.or(fall) } {
                Some(theta) if step.is_under_bar(self.foot, theta) => return Ok(Some(theta)),
                Some(theta) if theta < 1.0 => {
                    (from, below) = (advance.behind(theta, from), true);
                    self.below = self.below.or(Some(theta));
                }
                _ => return Ok(None),
            }
        }
        Ok(None)
    }
}

impl Kind for GapGuard {
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        step.gap(self.contact, theta)
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.size_of_gap(self.contact)
    }

    fn series<'s>(&self, view: &'s StepView<'_>) -> Option<&'s [f64]> {
        view.guards.map(|guards| guards.gap(self.contact))
    }

    fn begin_step(&mut self, view: &StepView<'_>, _: &mut Vec<f64>) {
        if view.is_fitted() {
            self.order = None;
        }
    }

    fn find_event(
        &mut self,
        tracking: &Tracking,
        step: &SampledStep<'_>,
        findings: &mut Findings,
    ) -> Option<Result<Option<f64>, GuardError>> {
        Some(self.find_closure(tracking, step, findings))
    }

    fn may_arrive(&self, step: &SampledStep<'_>) -> bool {
        step.is_under_bar(self.foot, 1.0)
    }

    fn end_step(&mut self, tracking: &Tracking, step: &SampledStep<'_>, end: f64) {
        let was_below = self.below.is_some_and(|from| from <= end);
        let is_below = (was_below || self.foot.is_some())
            && !tracking.is_above(self, step, end)
            && self.value(step, end) <= tracking.bound(self, step, &[])
            && (was_below || step.margin(self.foot, end) <= step.scales.end());
        self.below = is_below.then_some(0.0);
    }

    fn leave_step(&mut self, _: &Tracking, step: &SampledStep<'_>) {
        self.order = None;
        let is_low = |_: &LowFlight| step.scales.is_low(self.contact, self.value(step, 1.0));
        self.flight = self.flight.filter(is_low).map(|flight| flight.follow(self.contact, step));
    }

    fn is_below(&self) -> bool {
        self.below.is_some()
    }

    fn may_have_crossed(&self, scales: &Scales<'_>, _: &[f64], gaps: &[f64]) -> bool {
        scales.may_cross(gaps[self.contact], scales.size_of_gap(self.contact))
    }
}

#[cfg(test)]
mod tests;
