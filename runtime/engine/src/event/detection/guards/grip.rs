//! The margin of contacts that share their load.

use super::watch::{Kind, Watch};
use crate::event::detection::Guard;
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;

/// How far they are from slipping together.
pub(super) struct GripGuard;

impl GripGuard {
    const ASKED: Quantities = Quantities::REACTIONS.and(Quantities::GRIP);

    /// `kept` if it is zero at the start of the phase, and they have been decided to stick.
    pub(super) fn watch<'a>(kept: bool) -> Watch<'a> {
        Watch::new(Guard::SharedFriction, Self::ASKED, Self).suppressed(kept, Suppression::ToZero)
    }
}

impl Kind for GripGuard {
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        step.value(theta, Self::ASKED, |sample| sample.grip)
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.forces.iter().copied().fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::event::detection::tests::given::*;
    use crate::model::ContactSet;

    /// As large as the largest reaction.
    #[test]
    fn a_grip_has_the_size_of_its_reactions() {
        let scene = Scene::closed(ContactSet::EMPTY, |_| Shown::default());
        let largest = FORCES.into_iter().fold(0.0, f64::max);
        assert_eq!(scene.look(|step| GripGuard.size(step, &[])), largest);
    }
}
