//! Values of guards within a step.

use super::{Bounds, Guard};
use crate::integrate::Interpolant;
use crate::model::{BarSystem, KernelView, Phase};
use crate::moment::{At, Scene};
use crate::output::Condition;

/// A step of a phase.
pub(crate) struct StepView<'a, M: BarSystem, const N: usize> {
    pub(crate) phase: &'a Phase<M, f64, N>,
    pub(crate) scene: &'a Scene<M>,
    pub(crate) dense: &'a Interpolant<f64, N>,
}

/// A time of a phase.
pub(crate) struct Instant<'a, M: BarSystem, const N: usize> {
    pub(super) phase: &'a Phase<M, f64, N>,
    pub(super) scene: &'a Scene<M>,
    pub(super) t: f64,
    pub(super) reduced: [f64; N],
}

impl<M: BarSystem, const N: usize> StepView<'_, M, N> {
    pub(super) fn at(&self, theta: f64) -> Instant<'_, M, N> {
        let t = self.dense.t0 + theta * self.dense.h;
        Instant { phase: self.phase, scene: self.scene, t, reduced: self.dense.at(theta) }
    }
}

impl<M: BarSystem, const N: usize> Instant<'_, M, N> {
    pub(super) fn value(&self, conditions: &[Condition], guard: Guard) -> f64 {
        let constants = &self.scene.constants;
        let state = || (self.phase.embed)(constants, &self.reduced);
        match guard {
            Guard::Reaction(i) => {
                (self.phase.reactions)(constants, self.phase.set, &self.reduced).as_ref()[i]
            }
            Guard::Gap(i) => M::kernel(constants, &state()).gap()[i],
            Guard::Foot { entry, .. } => M::feet(constants, &state()).as_ref()[entry],
            Guard::Condition(k) => self.difference(&conditions[k]).0,
        }
    }

    pub(super) fn difference(&self, condition: &Condition) -> (f64, f64) {
        let moment = At::new(self.phase, &self.scene.constants, self.t, self.reduced);
        condition.difference(self.scene, &moment)
    }

    pub(super) fn under_bar(&self, contact: usize, bounds: Bounds) -> bool {
        let Some(foot) = M::LAYOUT.contacts[contact].foot else { return true };
        let constants = &self.scene.constants;
        let feet = M::feet(constants, &(self.phase.embed)(constants, &self.reduced));
        feet.as_ref()[2 * foot..2 * foot + 2].iter().all(|margin| *margin >= -bounds.relative * bounds.length)
    }
}
