//! The slip velocity of a contact that slides.

use super::watched::Watched;
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;
use crate::event::detection::step::StepView;
use crate::event::detection::{Guard, Rub};

/// σ v: at zero the contact stops.
pub(crate) struct SlipGuard {
    rub: Rub,
    /// The place of its slip velocity behind the gaps.
    velocity: usize,
    /// It is zero at the start of the phase, and the contact has been decided to go on sliding.
    kept: bool,
    /// Over the step, if the method has it.
    series: Vec<f64>,
}

impl SlipGuard {
    pub(crate) fn new(rub: Rub, velocity: usize, kept: bool) -> Self {
        Self { rub, velocity, kept, series: Vec::new() }
    }
}

impl Watched for SlipGuard {
    fn guard(&self) -> Guard {
        Guard::Slip(self.rub)
    }

    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        let Rub { friction, slip, .. } = self.rub;
        step.value(theta, self.asked(), |sample| f64::from(slip.sign()) * sample.slips[friction].velocity)
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.slips[self.rub.friction]
    }

    fn asked(&self) -> Quantities {
        Quantities::SLIPS
    }

    fn series<'s>(&'s self, _: &'s StepView<'_>) -> Option<&'s [f64]> {
        Some(&self.series[..]).filter(|series| !series.is_empty())
    }

    fn begin_step(&mut self, view: &StepView<'_>) {
        let Rub { contact, slip, .. } = self.rub;
        self.series.clear();
        if let Some(guards) = view.own_guards(contact) {
            let velocity = guards.gap(self.velocity).iter();
            self.series.extend(velocity.map(|velocity| f64::from(slip.sign()) * velocity));
        }
    }

    fn suppression(&self) -> Suppression {
        if self.kept { Suppression::ToBound } else { Suppression::None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::event::detection::guards::{Findings, Tracking};
    use crate::event::detection::tests::given::*;
    use crate::integrate::Guards;
    use crate::model::{ContactSet, Side, Slip};
    use crate::series::ORDERS;

    /// σ v with v = σ (0.5 − t), by its values and by its series, which it has only where it is one of the phase.
    #[test]
    fn a_slip_stops_in_its_sense() {
        for (slip, sigma) in [(Slip::Forward, 1.0), (Slip::Backward, -1.0)] {
            let velocity = move |t: f64| {
                let mut shown = Shown::default();
                shown.slips[1] = [sigma * (0.5 - t), 0.25];
                shown
            };
            let [rest, mut gaps] = [[[0.0; ORDERS]; CONTACTS + FRICTIONS]; 2];
            gaps[CONTACTS + 1] = padded(&[0.5 * sigma, -sigma]);
            let series = Guards::new(2, &rest, &gaps, &[[0.0; ORDERS]; 2]);
            let rub = Rub { contact: GUIDE, friction: 1, slip, side: Side::Positive };
            let mut guard = SlipGuard::new(rub, CONTACTS + 1, false);
            for closed in [ContactSet::EMPTY.slipping(GUIDE, slip), ContactSet::EMPTY] {
                Scene::closed(closed, velocity).look_with(Some(series), |step| {
                    guard.begin_step(step.view);
                    let has_series = closed.contains(GUIDE);
                    assert_eq!(guard.series(step.view), has_series.then_some(&[0.5, -1.0][..]));
                    let tracking = Tracking { has_series, ..Tracking::default() };
                    let at = guard.find_event(tracking, step, &mut Findings::default());
                    assert!(at.is_ok_and(|at| at.is_some_and(|at| (at - 0.5).abs() < 1e-12)), "{at:?}");
                });
            }
        }
    }
}
