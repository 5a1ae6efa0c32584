//! The border of Painlevé's region: where the normal reaction of a contact that slides stops to
//! hold it,
//!
//! ```text
//! p = (W_NN − σ μ W_Nt) / W_NN → 0,    N = N⁰ / p → ∞
//! ```
//!
//! Accelerations grow beyond all bounds towards it, so that steps shrink and guards turn ever
//! faster. A phase ends there.

use crate::numerics::zero::RANK;
use crate::system::PhaseStepper;

use super::PhaseRun;
use super::record::Recording;

/// A phase whose steps cannot be made any shorter has ended at the border where p is less than
/// this. There p may vanish as the root of the time that is left.
const STUCK: f64 = 1e-4;

/// Where a step lies that failed.
pub(super) enum Border {
    /// Not at the border.
    Elsewhere,
    /// The border lies within the step.
    Within,
    /// The step begins at the border.
    Reached,
}

impl PhaseRun<'_> {
    /// Where the last step lies, over which a guard was not resolved.
    pub(super) fn border(&self, recording: &Recording, stepper: &dyn PhaseStepper) -> Border {
        let Some(step) = recording.last() else { return Border::Elsewhere };
        match (self.hold(&step.start()), self.hold(stepper.state())) {
            (Some(p), _) if p <= RANK => Border::Reached,
            (Some(p), _) if p < STUCK => Border::Within,
            (Some(_), Some(end)) if end.is_nan() || end <= 0.0 => Border::Within,
            _ => Border::Elsewhere,
        }
    }

    /// Whether no shorter step from a reduced state is possible because the phase has come to the
    /// border.
    pub(super) fn is_at_border(&self, state: &[f64]) -> bool {
        self.hold(state).is_some_and(|p| p.abs() < STUCK)
    }

    /// The least p of the contacts that slide, at a reduced state.
    fn hold(&self, reduced: &[f64]) -> Option<f64> {
        let (set, rough) = (self.phase.info().set, self.parts.laws.rough?);
        let system = self.context.system();
        system.layout().sliding(&set).next()?;
        (rough.least_hold)(system, &self.embedded(reduced), &set)
    }
}
