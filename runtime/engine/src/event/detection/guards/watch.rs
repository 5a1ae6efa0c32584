//! What all guards have in common.

use crate::event::detection::guard_source::{EXACT, GuardSource, Suppression, is_clear, is_exact};
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::{SampledStep, Scales};
use crate::event::detection::step::StepView;
use crate::event::detection::{Guard, LOW};
use crate::numerics::root_isolation::{GuardError, NODES, RootStart};

/// The fraction of a run's last step over which a guard must fall to count as zero at its end.
const LAST: f64 = 1.0 / 64.0;
/// Where a guard that began a step at zero is looked at: a flight may be over in a single step.
const WITHIN: [f64; 4] = [1.0, 0.75, 0.5, 0.25];

/// What is found in a step beside events.
#[derive(Default)]
pub(crate) struct Findings {
    /// Guards that touch zero.
    pub(crate) touches: Vec<(f64, Guard)>,
    /// Where a condition may hide a root beside a pole.
    pub(crate) undecided: Option<f64>,
}

/// What only one kind of guard has.
pub(crate) trait Kind {
    /// Its value at θ.
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64;

    /// Its natural size, of which a part counts as zero; of a condition at some times of the step.
    fn size(&self, step: &SampledStep<'_>, at: &[f64]) -> f64;

    /// The method's own series of it, Σ cₖ θᵏ.
    fn series<'s>(&self, _: &'s StepView<'_>) -> Option<&'s [f64]> {
        None
    }

    /// Takes note of a dense output at rest at the start of the phase; tells whether it is zero
    /// there, where another bound than its usual one tells it.
    fn begin(&mut self, _: &SampledStep<'_>) -> Option<bool> {
        None
    }

    /// Takes note of a step before it is looked at; writes a series that follows from others that
    /// the method has.
    fn begin_step(&mut self, _: &StepView<'_>, _series: &mut Vec<f64>) {}

    /// Its first event in (0, 1], where that is another than its first fall.
    fn find_event(
        &mut self,
        _: &Tracking,
        _: &SampledStep<'_>,
        _: &mut Findings,
    ) -> Option<Result<Option<f64>, GuardError>> {
        None
    }

    /// Whether it may count as zero at the end of the last step, where it has fallen into its
    /// bound.
    fn may_arrive(&self, _: &SampledStep<'_>) -> bool {
        true
    }

    /// It belongs to an event that precedes its root by this part of the step.
    fn precedence(&self) -> f64 {
        0.0
    }

    /// Takes note of what it is at the end of a step, which may have been made shorter.
    fn end_step(&mut self, _: &Tracking, _: &SampledStep<'_>, _end: f64) {}

    /// Takes note of what the next step needs to know of this one.
    fn leave_step(&mut self, _: &Tracking, _: &SampledStep<'_>) {}

    /// Whether it is the gap of a contact that closes only after it has come back.
    fn is_below(&self) -> bool {
        false
    }

    /// Whether it may have crossed zero where it touches it, given all reactions and gaps there.
    fn may_have_crossed(&self, _: &Scales<'_>, _reactions: &[f64], _gaps: &[f64]) -> bool {
        false
    }
}

/// What is known of a guard of any kind.
pub(crate) struct Tracking {
    pub(crate) guard: Guard,
    /// What its values follow from.
    pub(crate) asked: Quantities,
    pub(crate) suppression: Suppression,
    /// How high it will be in a low flight, whose bound is tighter than usual; else infinite. No
    /// `Option`: what that has in place of a value may be a subnormal, which compilers multiply all
    /// the same, and processors slowly.
    pub(crate) height: f64,
    /// Its series over the step where it follows from others.
    series: Vec<f64>,
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
    pub(super) fn start(&self) -> RootStart {
        if self.at_root { RootStart::Root } else { RootStart::Free }
    }

    pub(super) fn series<'s>(&'s self, kind: &dyn Kind, view: &'s StepView<'_>) -> Option<&'s [f64]> {
        if self.series.is_empty() { kind.series(view) } else { Some(&self.series) }
    }

    /// What counts as zero.
    pub(super) fn bound(&self, kind: &dyn Kind, step: &SampledStep<'_>, at: &[f64]) -> f64 {
        (step.scales.bounds.relative * kind.size(step, at)).min(self.height * LOW)
    }

    /// Whether it is within its bound.
    pub(super) fn is_zero(&self, kind: &dyn Kind, step: &SampledStep<'_>, theta: f64) -> bool {
        kind.value(step, theta).abs() <= self.bound(kind, step, &[theta])
    }

    /// Whether its series tells that it is above its bound, however much of that its error takes.
    pub(super) fn is_above(&self, kind: &dyn Kind, step: &SampledStep<'_>, theta: f64) -> bool {
        let series = || self.series(kind, step.view).filter(|_| self.has_series);
        let at = |c: &[f64]| c.iter().rev().fold(0.0, |sum, c| sum * theta + c);
        self.is_clear || series().is_some_and(|c| at(c) > (1.0 + EXACT) * self.bound(kind, step, &[]))
    }

    /// Its first fall through zero.
    fn find_fall(
        &self,
        kind: &dyn Kind,
        step: &SampledStep<'_>,
        findings: &mut Findings,
    ) -> Result<Option<f64>, GuardError> {
        let value = |theta: f64| kind.value(step, theta);
        let (source, bound) = self.trace(kind, step, &value);
        let touch = &mut |theta| findings.touches.push((theta, self.guard));
        source.find_fall(bound, (0.0, self.start()), self.suppression, touch)
    }

    /// It over the step, and the bound below which it counts as zero.
    pub(super) fn trace<'s>(
        &'s self,
        kind: &dyn Kind,
        step: &'s SampledStep<'_>,
        value: &'s dyn Fn(f64) -> f64,
    ) -> (GuardSource<'s>, f64) {
        let source = match self.series(kind, step.view) {
            Some(series) if self.has_series => GuardSource::Series(series),
            _ => {
                let size = NODES.iter().fold(0.0_f64, |most, theta| most.max(value(*theta).abs()));
                GuardSource::Values { value, size, is_noisy: self.is_noisy }
            }
        };
        let bound = self.bound(kind, step, &[]).max(source.rounding());
        (source, bound)
    }
}

/// A guard.
pub(crate) struct Watch<'a> {
    pub(crate) kind: Box<dyn Kind + 'a>,
    pub(crate) tracking: Tracking,
}

impl<'a> Watch<'a> {
    pub(super) fn new(guard: Guard, asked: Quantities, kind: impl Kind + 'a) -> Self {
        let tracking = Tracking {
            guard,
            asked,
            suppression: Suppression::None,
            height: f64::INFINITY,
            series: Vec::new(),
            at_root: false,
            has_series: false,
            is_clear: false,
            is_noisy: false,
        };
        Self { kind: Box::new(kind), tracking }
    }

    /// The same with what has been decided of it, if anything has.
    pub(super) fn suppressed(mut self, kept: bool, suppression: Suppression) -> Self {
        self.tracking.suppression = if kept { suppression } else { Suppression::None };
        self
    }

    /// Takes note of what the phase begins with, at a dense output at rest.
    pub(crate) fn begin(&mut self, start: &SampledStep<'_>) {
        let Self { kind, tracking } = self;
        if tracking.height.is_finite() {
            // A flight that begins so deep has its ground there.
            tracking.height = tracking.height.max(2.0 * (-kind.value(start, 0.0)).max(0.0) / LOW);
        }
        let told = kind.begin(start);
        self.tracking.at_root = told.unwrap_or_else(|| self.is_zero(start, 0.0));
    }

    /// What its series proves of it in a step.
    pub(crate) fn begin_step(&mut self, step: &SampledStep<'_>) {
        let Self { kind, tracking } = self;
        tracking.series.clear();
        kind.begin_step(step.view, &mut tracking.series);
        let found = tracking.series(&**kind, step.view).map_or([false; 2], |series| {
            let bound = tracking.bound(&**kind, step, &[]);
            [is_exact(series, bound), is_clear(series, bound)]
        });
        [tracking.has_series, tracking.is_clear] = found;
    }

    pub(crate) fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        self.kind.value(step, theta)
    }

    pub(crate) fn bound(&self, step: &SampledStep<'_>, at: &[f64]) -> f64 {
        self.tracking.bound(&*self.kind, step, at)
    }

    pub(crate) fn is_zero(&self, step: &SampledStep<'_>, theta: f64) -> bool {
        self.tracking.is_zero(&*self.kind, step, theta)
    }

    pub(crate) fn is_above(&self, step: &SampledStep<'_>, theta: f64) -> bool {
        self.tracking.is_above(&*self.kind, step, theta)
    }

    /// What is evaluated at the nodes of the first fit: nothing where its series counts as it or
    /// proves it clear.
    pub(crate) fn sampled(&self) -> Option<Quantities> {
        let Tracking { asked, has_series, is_clear, .. } = self.tracking;
        (!has_series && !is_clear).then_some(asked)
    }

    /// The first event in a step.
    pub(crate) fn find_event(
        &mut self,
        step: &SampledStep<'_>,
        findings: &mut Findings,
    ) -> Result<Option<f64>, GuardError> {
        let Self { kind, tracking } = self;
        if tracking.is_clear {
            return Ok(None);
        }
        let own = kind.find_event(tracking, step, findings);
        own.unwrap_or_else(|| tracking.find_fall(&**kind, step, findings))
    }

    /// The same in a step that cannot be made shorter, as far as its samples show it.
    pub(crate) fn find_event_in_noise(
        &mut self,
        step: &SampledStep<'_>,
        findings: &mut Findings,
    ) -> Option<f64> {
        let before = core::mem::replace(&mut self.tracking.is_noisy, true);
        let found = self.find_event(step, findings);
        self.tracking.is_noisy = before;
        found.unwrap_or(None)
    }

    /// Whether it has fallen into its bound at the end of the step, and not with a turning point
    /// there: it falls by as much as before.
    pub(crate) fn arrives(&self, step: &SampledStep<'_>) -> bool {
        if self.tracking.is_clear || self.tracking.at_root || !self.kind.may_arrive(step) {
            return false;
        }
        let places = [1.0 - 2.0 * LAST, 1.0 - LAST, 1.0];
        let ([before, near, end], bound) =
            (places.map(|theta| self.value(step, theta)), self.bound(step, &[]));
        end.abs() <= bound && near - end > bound && near - end > 0.75 * (before - near)
    }

    /// Takes note of a step that ends at a place, and of what another one that follows needs to
    /// know.
    pub(crate) fn end_step(&mut self, step: &SampledStep<'_>, end: f64, is_followed: bool) {
        self.kind.end_step(&self.tracking, step, end);
        if is_followed {
            self.kind.leave_step(&self.tracking, step);
            let at_root = self.tracking.at_root;
            self.tracking.at_root = at_root && WITHIN.iter().all(|theta| self.is_zero(step, *theta));
        }
    }
}
