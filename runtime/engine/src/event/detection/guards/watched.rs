//! What all guards have in common.

use crate::event::detection::guard_source::{EXACT, GuardSource, Suppression};
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::{SampledStep, Scales};
use crate::event::detection::step::StepView;
use crate::event::detection::{Guard, LOW};
use crate::numerics::root_isolation::{GuardError, NODES, Start};

/// What is known of a guard of any kind.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Tracking {
    /// Its value has not left its bound since the phase began with it at zero.
    pub(crate) at_root: bool,
    /// Whether its own series over the step counts as it.
    pub(crate) has_series: bool,
    /// Whether its own series proves that it stays above its bound in the step.
    pub(crate) is_clear: bool,
    /// Whether it is taken for noise where it turns too often to be followed.
    pub(crate) is_noisy: bool,
}

impl Tracking {
    /// Whether its values at the nodes of the first fit are asked for: its series neither counts as it nor proves it clear.
    pub(crate) fn is_sampled(&self) -> bool {
        !self.has_series && !self.is_clear
    }

    pub(super) fn start(&self) -> Start {
        if self.at_root { Start::Root } else { Start::Free }
    }
}

/// What is found in a step beside events.
#[derive(Default)]
pub(crate) struct Findings {
    /// Guards that touch zero.
    pub(crate) touches: Vec<(f64, Guard)>,
    /// Where a condition may hide a root beside a pole.
    pub(crate) undecided: Option<f64>,
}

/// A guard with what is known of it from step to step.
pub(crate) trait Watched {
    /// What is watched.
    fn guard(&self) -> Guard;

    /// Its value at θ.
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64;

    /// Its natural size, of which a part counts as zero; of a condition at some times of the step.
    fn size(&self, step: &SampledStep<'_>, at: &[f64]) -> f64;

    /// What its values follow from.
    fn asked(&self) -> Quantities {
        Quantities::NONE
    }

    /// How high it will be in a low flight, whose bound is tighter than usual; else infinite. No `Option`: what that has in
    /// place of a value may be a subnormal, which compilers multiply all the same, and processors slowly.
    fn height(&self) -> f64 {
        f64::INFINITY
    }

    /// Its own series over the step, Σ cₖ θᵏ, if the method has it.
    fn series<'s>(&'s self, _: &'s StepView<'_>) -> Option<&'s [f64]> {
        None
    }

    /// Whether it is zero at the start of the phase, given a dense output at rest there.
    fn begin(&mut self, start: &SampledStep<'_>) -> bool {
        self.is_zero(start, 0.0)
    }

    /// Takes note of a step before it is looked at.
    fn begin_step(&mut self, _: &StepView<'_>) {}

    /// What is decided of it where it begins the phase at zero.
    fn suppression(&self) -> Suppression {
        Suppression::None
    }

    /// Its first event in (0, 1].
    fn find_event(
        &mut self,
        tracking: Tracking,
        step: &SampledStep<'_>,
        findings: &mut Findings,
    ) -> Result<Option<f64>, GuardError> {
        let value = |theta: f64| self.value(step, theta);
        let (source, bound) = trace(self, tracking, step, &value);
        let touch = &mut |theta| findings.touches.push((theta, self.guard()));
        source.find_fall(bound, (0.0, tracking.start()), self.suppression(), touch)
    }

    /// Whether it may count as zero at the end of the last step, where it has fallen into its bound.
    fn may_arrive(&self, _: &SampledStep<'_>) -> bool {
        true
    }

    /// It belongs to an event that precedes its root by this part of the step.
    fn precedence(&self) -> f64 {
        0.0
    }

    /// Takes note of what it is at the end of a step, which may have been made shorter.
    fn end_step(&mut self, _: Tracking, _: &SampledStep<'_>, _end: f64) {}

    /// Takes note of what the next step needs to know of this one.
    fn leave_step(&mut self, _: &SampledStep<'_>) {}

    /// Whether it is a corner below its bar, which it has come to from beyond the end.
    fn has_passed(&self) -> bool {
        false
    }

    /// Whether it may have crossed zero where it touches it, given all reactions and gaps there.
    fn may_have_crossed(&self, _scales: &Scales<'_>, _reactions: &[f64], _gaps: &[f64]) -> bool {
        false
    }

    /// What counts as zero.
    fn bound(&self, step: &SampledStep<'_>, at: &[f64]) -> f64 {
        (step.scales.bounds.relative * self.size(step, at)).min(self.height() * LOW)
    }

    /// Whether it is within its bound.
    fn is_zero(&self, step: &SampledStep<'_>, theta: f64) -> bool {
        self.value(step, theta).abs() <= self.bound(step, &[theta])
    }

    /// Whether its series tells that it is above its bound, however much of that its error takes.
    fn is_above(&self, tracking: Tracking, step: &SampledStep<'_>, theta: f64) -> bool {
        let series = || self.series(step.view).filter(|_| tracking.has_series);
        let at = |c: &[f64]| c.iter().rev().fold(0.0, |sum, c| sum * theta + c);
        tracking.is_clear || series().is_some_and(|c| at(c) > (1.0 + EXACT) * self.bound(step, &[]))
    }
}

/// A guard over the step, and the bound below which it counts as zero.
pub(super) fn trace<'s, G: Watched + ?Sized>(
    guard: &'s G,
    tracking: Tracking,
    step: &'s SampledStep<'_>,
    value: &'s dyn Fn(f64) -> f64,
) -> (GuardSource<'s>, f64) {
    let source = match guard.series(step.view) {
        Some(series) if tracking.has_series => GuardSource::Series(series),
        _ => {
            let size = NODES.iter().fold(0.0_f64, |most, theta| most.max(value(*theta).abs()));
            GuardSource::Values { value, size, is_noisy: tracking.is_noisy }
        }
    };
    let bound = guard.bound(step, &[]).max(source.rounding());
    (source, bound)
}
