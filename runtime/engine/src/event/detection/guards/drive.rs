//! The gap of what a drive moves.

use super::watch::{Findings, Kind, Tracking, Watch};
use crate::event::detection::Guard;
use crate::event::detection::contact_status::ContactStatus;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;
use crate::event::detection::step::StepView;
use crate::numerics::root_isolation::{GuardError, RootStart};

/// g, which may come to zero from either side.
pub(super) struct DriveGuard {
    contact: usize,
    /// Whether it is above zero at the end of the last step.
    sign: Option<bool>,
}

impl DriveGuard {
    pub(super) fn watch<'a>(contact: usize, status: &ContactStatus<'_>) -> Watch<'a> {
        let mut watch = Watch::new(Guard::Gap(contact), Quantities::GAPS, Self { contact, sign: None });
        watch.tracking.height = status.height(contact);
        watch
    }
}

impl Kind for DriveGuard {
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        step.gap(self.contact, theta)
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.size_of_gap(self.contact)
    }

    fn series<'s>(&self, view: &'s StepView<'_>) -> Option<&'s [f64]> {
        view.guards.map(|guards| guards.gap(self.contact))
    }

    fn find_event(
        &mut self,
        tracking: &Tracking,
        step: &SampledStep<'_>,
        _: &mut Findings,
    ) -> Option<Result<Option<f64>, GuardError>> {
        let value = |theta: f64| self.value(step, theta);
        let (source, bound) = tracking.trace(self, step, &value);
        let known = self.sign.filter(|_| !tracking.at_root).map(|positive| RootStart::Continues { positive });
        Some(source.first_root(0.0, known.unwrap_or(tracking.start()), (0.0, bound)))
    }

    fn leave_step(&mut self, _: &Tracking, step: &SampledStep<'_>) {
        self.sign = Some(self.value(step, 1.0) > 0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::event::detection::tests::given::*;
    use crate::model::ContactSet;

    /// A gap of ±(0.5 − t) that begins beyond its bound, and one that the last step has left on the
    /// other side of zero.
    #[test]
    fn a_gap_of_a_drive_continues_with_its_sign() {
        for sign in [1.0, -1.0] {
            let scene = Scene::closed(ContactSet::EMPTY, move |t| {
                let mut shown = Shown::default();
                shown.gaps[DRIVE] = sign * (0.5 - t);
                shown
            });
            let tracking = DriveGuard::watch(DRIVE, &roles(ContactSet::EMPTY)).tracking;
            let mut guard = DriveGuard { contact: DRIVE, sign: None };
            let find = |guard: &mut DriveGuard| {
                scene.look(|step| {
                    guard.find_event(&tracking, step, &mut Findings::default()).expect("its own")
                })
            };
            let at = find(&mut guard);
            assert!(at.is_ok_and(|at| at.is_some_and(|at| (at - 0.5).abs() < 1e-12)), "{at:?}");
            scene.look(|step| guard.leave_step(&tracking, step));
            assert_eq!(guard.sign, Some(sign < 0.0));
        }
    }
}
