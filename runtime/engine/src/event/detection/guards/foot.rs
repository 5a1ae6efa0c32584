//! The foot of a closed corner.

use super::watch::{Kind, Watch};
use crate::event::detection::Guard;
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;
use crate::event::detection::step::StepView;

/// How far the foot is from one end of its bar.
pub(super) struct FootGuard {
    /// The entry of the model's feet.
    entry: usize,
}

impl FootGuard {
    pub(super) fn watch<'a>(contact: usize, entry: usize) -> Watch<'a> {
        Watch::new(Guard::Foot { contact, entry }, Quantities::FEET, Self { entry })
    }
}

impl Kind for FootGuard {
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        step.value(theta, Quantities::FEET, |sample| sample.feet[self.entry])
    }

    fn size(&self, step: &SampledStep<'_>, _: &[f64]) -> f64 {
        step.scales.bounds.length
    }

    fn series<'s>(&self, view: &'s StepView<'_>) -> Option<&'s [f64]> {
        view.guards.map(|guards| guards.foot(self.entry / 2, self.entry % 2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::event::detection::guards::Findings;
    use crate::event::detection::tests::given::*;
    use crate::integrate::Guards;
    use crate::series::ORDERS;

    /// The foot leaves its bar at either end.
    #[test]
    fn a_foot_slides_off_at_either_end() {
        let scene =
            Scene::closed(set(&[CORNER]), |t| Shown { feet: [0.75 - t, 0.25 - t], ..Shown::default() });
        let rest = [[0.0; ORDERS]; CONTACTS + FRICTIONS];
        let feet = [0.75, 0.25].map(|first| padded(&[first, -1.0]));
        for (entry, expected) in [(0, 0.75), (1, 0.25)] {
            let mut watch = FootGuard::watch(CORNER, entry);
            scene.look_with(Some(Guards::new(2, &rest, &rest, &feet)), |step| {
                assert_eq!(watch.kind.series(step.view), Some(&[expected, -1.0][..]));
                for has_series in [false, true] {
                    watch.tracking.has_series = has_series;
                    let at = watch.find_event(step, &mut Findings::default());
                    assert!(at.is_ok_and(|at| at.is_some_and(|at| (at - expected).abs() < 1e-12)), "{at:?}");
                }
            });
        }
    }
}
