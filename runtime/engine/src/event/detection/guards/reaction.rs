//! The reaction of a closed contact.

use super::watched::Watched;
use crate::event::detection::Guard;
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::{SampledStep, Scales};
use crate::event::detection::step::StepView;
use crate::model::Side;

/// N of a support, s N of a guide with friction that presses to a side.
pub(crate) struct ReactionGuard {
    contact: usize,
    side: Option<Side>,
    /// It is zero at the start of the phase, and its contact has been decided to stay closed.
    kept: bool,
    /// −N over the step, where it presses to the negative side.
    negated: Vec<f64>,
}

impl ReactionGuard {
    pub(crate) fn new(contact: usize, side: Option<Side>, kept: bool) -> Self {
        Self { contact, side, kept, negated: Vec::new() }
    }
}

impl Watched for ReactionGuard {
    fn guard(&self) -> Guard {
        self.side.map_or(Guard::Reaction(self.contact), |side| Guard::Side(self.contact, side))
    }

    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        let sign = self.side.map_or(1.0, |side| f64::from(side.sign()));
        step.value(theta, self.asked(), |sample| sign * sample.reactions[self.contact])
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.forces[self.contact]
    }

    fn asked(&self) -> Quantities {
        Quantities::REACTIONS
    }

    fn series<'s>(&'s self, view: &'s StepView<'_>) -> Option<&'s [f64]> {
        match self.side {
            Some(Side::Negative) => Some(&self.negated[..]).filter(|series| !series.is_empty()),
            _ => view.guards.map(|guards| guards.reaction(self.contact)),
        }
    }

    fn begin_step(&mut self, view: &StepView<'_>) {
        self.negated.clear();
        if self.side == Some(Side::Negative)
            && let Some(guards) = view.own_guards(self.contact)
        {
            self.negated.extend(guards.reaction(self.contact).iter().map(|normal| -normal));
        }
    }

    fn suppression(&self) -> Suppression {
        if self.kept { Suppression::ToBound } else { Suppression::None }
    }

    fn may_have_crossed(&self, scales: &Scales<'_>, reactions: &[f64], _: &[f64]) -> bool {
        scales.may_cross(reactions[self.contact], scales.forces[self.contact])
    }
}

#[cfg(test)]
mod tests;
