//! The slip velocity of a contact that slides.

use super::watch::{Kind, Watch};
use crate::event::detection::guard_source::Suppression;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;
use crate::event::detection::step::StepView;
use crate::event::detection::{FrictionGuard, Guard};

/// σ v: at zero the contact stops.
pub(super) struct SlipGuard {
    rub: FrictionGuard,
    /// The place of its series behind those of the gaps.
    row: usize,
}

impl SlipGuard {
    /// `kept` if it is zero at the start of the phase, and the contact has been decided to go on
    /// sliding.
    pub(super) fn watch<'a>(rub: FrictionGuard, row: usize, kept: bool) -> Watch<'a> {
        let watch = Watch::new(Guard::Slip(rub), Quantities::SLIPS, Self { rub, row });
        watch.suppressed(kept, Suppression::ToBound)
    }
}

impl Kind for SlipGuard {
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        let FrictionGuard { friction, slip, .. } = self.rub;
        let velocity = step.value(theta, Quantities::SLIPS, |sample| sample.slips[friction].velocity);
        f64::from(slip.sign()) * velocity
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.slips[self.rub.friction]
    }

    fn begin_step(&mut self, view: &StepView<'_>, series: &mut Vec<f64>) {
        if let Some(guards) = view.own_guards(self.rub.contact) {
            let sign = f64::from(self.rub.slip.sign());
            series.extend(guards.gap(self.row).iter().map(|velocity| sign * velocity));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::event::detection::guards::Findings;
    use crate::event::detection::tests::given::*;
    use crate::integrate::Guards;
    use crate::model::{ContactSet, Side, Slip};
    use crate::series::ORDERS;

    /// σ v with v = σ (0.5 − t), by its values and by its series, which it has only where it is one
    /// of the phase.
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
            let rub = FrictionGuard { contact: GUIDE, friction: 1, slip, side: Side::Positive };
            let mut watch = SlipGuard::watch(rub, CONTACTS + 1, false);
            for closed in [ContactSet::EMPTY.slipping(GUIDE, slip), ContactSet::EMPTY] {
                Scene::closed(closed, velocity).look_with(Some(series), |step| {
                    watch.begin_step(step);
                    let has_series = closed.contains(GUIDE);
                    assert_eq!(
                        watch.tracking.series(&*watch.kind, step.view),
                        has_series.then_some(&[0.5, -1.0][..])
                    );
                    watch.tracking.has_series = has_series;
                    let at = watch.find_event(step, &mut Findings::default());
                    assert!(at.is_ok_and(|at| at.is_some_and(|at| (at - 0.5).abs() < 1e-12)), "{at:?}");
                });
            }
        }
    }
}
