//! The reaction of a closed contact.

use super::watch::{Kind, Watch};
use crate::event::detection::Guard;
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::{SampledStep, Scales};
use crate::event::detection::step::StepView;
use crate::model::Side;

/// N of a support, s N of a guide with friction that presses to a side.
pub(super) struct ReactionGuard {
    contact: usize,
    side: Option<Side>,
}

impl ReactionGuard {
    /// `kept` if it is zero at the start of the phase, and its contact has been decided to stay
    /// closed.
    pub(super) fn watch<'a>(contact: usize, side: Option<Side>, kept: bool) -> Watch<'a> {
        let guard = side.map_or(Guard::Reaction(contact), |side| Guard::Side(contact, side));
        Watch::new(guard, Quantities::REACTIONS, Self { contact, side })
            .suppressed(kept, Suppression::ToBound)
    }
}

impl Kind for ReactionGuard {
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        let sign = self.side.map_or(1.0, |side| f64::from(side.sign()));
        step.value(theta, Quantities::REACTIONS, |sample| sign * sample.reactions[self.contact])
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.forces[self.contact]
    }

    fn series<'s>(&self, view: &'s StepView<'_>) -> Option<&'s [f64]> {
        let guards = view.guards.filter(|_| self.side != Some(Side::Negative))?;
        Some(guards.reaction(self.contact))
    }

    fn begin_step(&mut self, view: &StepView<'_>, series: &mut Vec<f64>) {
        if self.side == Some(Side::Negative)
            && let Some(guards) = view.own_guards(self.contact)
        {
            series.extend(guards.reaction(self.contact).iter().map(|normal| -normal));
        }
    }

    fn may_have_crossed(&self, scales: &Scales<'_>, reactions: &[f64], _: &[f64]) -> bool {
        scales.may_cross(reactions[self.contact], scales.forces[self.contact])
    }
}

#[cfg(test)]
mod tests;
