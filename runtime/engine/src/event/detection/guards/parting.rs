//! The gap of a closed contact that depends on those that bear.

use super::watched::Watched;
use crate::event::detection::Guard;
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;

/// −g: below zero the contact depended on the others only where the phase began.
pub(crate) struct PartingGuard {
    pub(super) contact: usize,
}

impl Watched for PartingGuard {
    fn guard(&self) -> Guard {
        Guard::Parting(self.contact)
    }

    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        step.value(theta, self.asked(), |sample| -sample.gaps[self.contact])
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.size_of_gap(self.contact)
    }

    fn asked(&self) -> Quantities {
        Quantities::GAPS
    }

    /// It parts as soon as that is seen.
    fn suppression(&self) -> Suppression {
        Suppression::ToBound
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::event::detection::guards::{Findings, Tracking};
    use crate::event::detection::tests::given::*;
    use crate::model::ContactSet;

    /// A gap that grows as t², seen where it has left its bound.
    #[test]
    fn a_contact_parts_where_its_gap_has_left_its_bound() {
        let scene = Scene::closed(ContactSet::EMPTY, |t| {
            let mut shown = Shown::default();
            shown.gaps[PLAIN] = 32.0 * BOUNDS.relative * t * t;
            shown
        });
        let mut guard = PartingGuard { contact: PLAIN };
        scene.look(|step| {
            assert_eq!(guard.value(step, 0.5), -8.0 * BOUNDS.relative);
            let tracking = Tracking { at_root: guard.begin(step), ..Tracking::default() };
            let at = guard.find_event(tracking, step, &mut Findings::default());
            // The bound is that of a length of two.
            assert!(at.is_ok_and(|at| at.is_some_and(|at| (at - 0.25).abs() < 1e-9)), "{at:?}");
        });
    }
}
