//! The margin of contacts that share their load.

use super::watched::Watched;
use crate::event::detection::Guard;
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;

/// How far they are from slipping together.
pub(crate) struct GripGuard {
    /// It is zero at the start of the phase, and they have been decided to stick.
    pub(super) kept: bool,
}

impl Watched for GripGuard {
    fn guard(&self) -> Guard {
        Guard::Grip
    }

    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        step.value(theta, self.asked(), |sample| sample.grip)
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.forces.iter().copied().fold(0.0, f64::max)
    }

    fn asked(&self) -> Quantities {
        Quantities::REACTIONS.and(Quantities::GRIP)
    }

    fn suppression(&self) -> Suppression {
        if self.kept { Suppression::ToZero } else { Suppression::None }
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
        assert_eq!(scene.look(|step| GripGuard { kept: false }.size(step, &[])), largest);
    }
}
