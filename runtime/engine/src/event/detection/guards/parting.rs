//! The gap of a closed contact that depends on those that bear.

use super::watch::{Kind, Watch};
use crate::event::detection::Guard;
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;

/// −g: below zero the contact depended on the others only where the phase began.
pub(super) struct PartingGuard {
    contact: usize,
}

impl PartingGuard {
    /// It parts as soon as that is seen.
    pub(super) fn watch<'a>(contact: usize) -> Watch<'a> {
        let watch = Watch::new(Guard::RedundantGap(contact), Quantities::GAPS, Self { contact });
        watch.suppressed(true, Suppression::ToBound)
    }
}

impl Kind for PartingGuard {
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        -step.gap(self.contact, theta)
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.size_of_gap(self.contact)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::event::detection::guards::Findings;
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
        let mut watch = PartingGuard::watch(PLAIN);
        scene.look(|step| {
            assert_eq!(watch.value(step, 0.5), -8.0 * BOUNDS.relative);
            watch.begin(step);
            let at = watch.find_event(step, &mut Findings::default());
            // The bound is that of a length of two.
            assert!(at.is_ok_and(|at| at.is_some_and(|at| (at - 0.25).abs() < 1e-9)), "{at:?}");
        });
    }
}
