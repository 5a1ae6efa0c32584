//! The friction force of a contact that sticks.

use super::watch::{Kind, Watch};
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;
use crate::event::detection::step::StepView;
use crate::event::detection::{FrictionGuard, Guard};

/// μₛ |N| + σ R: at zero the contact begins to slide with the sense σ.
pub(super) struct LimitGuard {
    rub: FrictionGuard,
    /// The place of its friction force behind the reactions.
    row: usize,
    /// μₛ, a constant of the model.
    coefficient: f64,
}

impl LimitGuard {
    const ASKED: Quantities = Quantities::REACTIONS.and(Quantities::SLIPS);

    /// `kept` if it is zero at the start of the phase, and the contact has been decided to stick.
    pub(super) fn watch<'a>(rub: FrictionGuard, row: usize, kept: bool) -> Watch<'a> {
        let watch = Watch::new(Guard::Limit(rub), Self::ASKED, Self { rub, row, coefficient: 0.0 });
        watch.suppressed(kept, Suppression::ToZero)
    }
}

impl Kind for LimitGuard {
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        let FrictionGuard { contact, friction, slip, side } = self.rub;
        step.value(theta, Self::ASKED, |sample| {
            let normal = f64::from(side.sign()) * sample.reactions[contact];
            sample.slips[friction].limit * normal + f64::from(slip.sign()) * sample.reactions[self.row]
        })
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.forces[self.rub.contact]
    }

    fn begin(&mut self, start: &SampledStep<'_>) -> Option<bool> {
        self.coefficient = start.value(0.0, Self::ASKED, |sample| sample.slips[self.rub.friction].limit);
        None
    }

    fn begin_step(&mut self, view: &StepView<'_>, series: &mut Vec<f64>) {
        let FrictionGuard { contact, slip, side, .. } = self.rub;
        if let Some(guards) = view.own_guards(contact) {
            let (limit, sign) = (f64::from(side.sign()) * self.coefficient, f64::from(slip.sign()));
            let terms = guards.reaction(contact).iter().zip(guards.reaction(self.row));
            series.extend(terms.map(|(normal, force)| limit * normal + sign * force));
        }
    }
}

#[cfg(test)]
mod tests;
