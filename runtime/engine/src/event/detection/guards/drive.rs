//! The gap of what a drive moves.

use super::contact_gap::Gap;
use super::watched::{Findings, Tracking, Watched, trace};
use crate::event::detection::Guard;
use crate::event::detection::contact_status::ContactStatus;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::{SampledStep, Scales};
use crate::event::detection::step::StepView;
use crate::numerics::root_isolation::{GuardError, Start};

/// g, which may come to zero from either side.
pub(crate) struct DriveGuard {
    gap: Gap,
    /// Whether it is above zero at the end of the last step.
    sign: Option<bool>,
}

impl DriveGuard {
    pub(super) fn new(contact: usize, status: &ContactStatus<'_>) -> Self {
        Self { gap: Gap::new(contact, status), sign: None }
    }
}

impl Watched for DriveGuard {
    fn guard(&self) -> Guard {
        Guard::Gap(self.gap.contact)
    }

    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        self.gap.value(step, theta)
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.size_of_gap(self.gap.contact)
    }

    fn asked(&self) -> Quantities {
        Quantities::GAPS
    }

    fn height(&self) -> f64 {
        self.gap.height
    }

    fn series<'s>(&'s self, view: &'s StepView<'_>) -> Option<&'s [f64]> {
        self.gap.series(view)
    }

    fn begin(&mut self, start: &SampledStep<'_>) -> bool {
        self.gap.begin(start);
        self.is_zero(start, 0.0)
    }

    fn find_event(
        &mut self,
        tracking: Tracking,
        step: &SampledStep<'_>,
        _: &mut Findings,
    ) -> Result<Option<f64>, GuardError> {
        let value = |theta: f64| self.value(step, theta);
        let (source, bound) = trace(self, tracking, step, &value);
        let known = self.sign.filter(|_| !tracking.at_root).map(|positive| Start::Continues { positive });
        source.first_root(0.0, known.unwrap_or(tracking.start()), (0.0, bound))
    }

    fn leave_step(&mut self, step: &SampledStep<'_>) {
        self.sign = Some(self.value(step, 1.0) > 0.0);
    }

    fn may_have_crossed(&self, scales: &Scales<'_>, _: &[f64], gaps: &[f64]) -> bool {
        self.gap.may_have_crossed(scales, gaps)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::event::detection::tests::given::*;
    use crate::model::ContactSet;

    /// A gap of ±(0.5 − t) that begins beyond its bound, and one that the last step has left on the other side of zero.
    #[test]
    fn a_gap_of_a_drive_continues_with_its_sign() {
        for sign in [1.0, -1.0] {
            let scene = Scene::closed(ContactSet::EMPTY, move |t| {
                let mut shown = Shown::default();
                shown.gaps[DRIVE] = sign * (0.5 - t);
                shown
            });
            let mut guard = DriveGuard::new(DRIVE, &roles(ContactSet::EMPTY));
            let find = |guard: &mut DriveGuard| {
                scene.look(|step| guard.find_event(Tracking::default(), step, &mut Findings::default()))
            };
            let at = find(&mut guard);
            assert!(at.is_ok_and(|at| at.is_some_and(|at| (at - 0.5).abs() < 1e-12)), "{at:?}");
            scene.look(|step| guard.leave_step(step));
            assert_eq!(guard.sign, Some(sign < 0.0));
        }
    }
}
