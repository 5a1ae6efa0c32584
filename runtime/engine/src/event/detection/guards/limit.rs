//! The friction force of a contact that sticks.

use super::watched::Watched;
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;
use crate::event::detection::step::StepView;
use crate::event::detection::{Guard, Rub};

/// μₛ |N| + σ R: at zero the contact begins to slide with the sense σ.
pub(crate) struct LimitGuard {
    rub: Rub,
    /// The place of its friction force behind the reactions.
    force: usize,
    /// It is zero at the start of the phase, and the contact has been decided to stick.
    kept: bool,
    /// μₛ, a constant of the model.
    coefficient: f64,
    /// Over the step, if the method has it.
    series: Vec<f64>,
}

impl LimitGuard {
    pub(crate) fn new(rub: Rub, force: usize, kept: bool) -> Self {
        Self { rub, force, kept, coefficient: 0.0, series: Vec::new() }
    }
}

impl Watched for LimitGuard {
    fn guard(&self) -> Guard {
        Guard::Limit(self.rub)
    }

    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        let Rub { contact, friction, slip, side } = self.rub;
        step.value(theta, self.asked(), |sample| {
            let force = sample.reactions[self.force];
            let normal = f64::from(side.sign()) * sample.reactions[contact];
            sample.slips[friction].limit * normal + f64::from(slip.sign()) * force
        })
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.forces[self.rub.contact]
    }

    fn asked(&self) -> Quantities {
        Quantities::REACTIONS.and(Quantities::SLIPS)
    }

    fn series<'s>(&'s self, _: &'s StepView<'_>) -> Option<&'s [f64]> {
        Some(&self.series[..]).filter(|series| !series.is_empty())
    }

    fn begin(&mut self, start: &SampledStep<'_>) -> bool {
        self.coefficient =
            start.value(0.0, Quantities::SLIPS, |sample| sample.slips[self.rub.friction].limit);
        self.is_zero(start, 0.0)
    }

    fn begin_step(&mut self, view: &StepView<'_>) {
        let Rub { contact, slip, side, .. } = self.rub;
        self.series.clear();
        if let Some(guards) = view.own_guards(contact) {
            let (limit, sign) = (f64::from(side.sign()) * self.coefficient, f64::from(slip.sign()));
            let terms = guards.reaction(contact).iter().zip(guards.reaction(self.force));
            self.series.extend(terms.map(|(normal, force)| limit * normal + sign * force));
        }
    }

    fn suppression(&self) -> Suppression {
        if self.kept { Suppression::ToZero } else { Suppression::None }
    }
}

#[cfg(test)]
mod tests;
