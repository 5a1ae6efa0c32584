//! Values of guards within a step.

use super::Guard;
use crate::integrate::Dense;
use crate::model::{BarSystem, KernelView, Phase};
use crate::moment::{At, Scene};
use crate::output::Condition;

/// Which guards are asked for.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Kinds {
    pub(super) reactions: bool,
    pub(super) gaps: bool,
    pub(super) feet: bool,
}

impl Kinds {
    pub(super) fn of(guards: impl IntoIterator<Item = Guard>) -> Self {
        guards.into_iter().fold(Self::default(), |kinds, guard| match guard {
            Guard::Reaction(_) => Self { reactions: true, ..kinds },
            Guard::Gap(_) => Self { gaps: true, ..kinds },
            Guard::Foot { .. } => Self { feet: true, ..kinds },
            Guard::Condition(_) => kinds,
        })
    }

    pub(super) fn any(self) -> bool {
        self.reactions || self.gaps || self.feet
    }
}

/// Values of all guards of a model at one time; those not asked for are left as they were.
#[derive(Debug, Default)]
pub(crate) struct Values {
    reactions: Vec<f64>,
    gaps: Vec<f64>,
    feet: Vec<f64>,
}

impl Values {
    pub(super) fn of<M: BarSystem>() -> Self {
        let (contacts, feet) = (M::LAYOUT.contacts.len(), 2 * M::LAYOUT.contacts.len());
        Self { reactions: vec![0.0; contacts], gaps: vec![0.0; contacts], feet: vec![0.0; feet] }
    }

    /// NaN for a condition.
    pub(super) fn get(&self, guard: Guard) -> f64 {
        match guard {
            Guard::Reaction(i) => self.reactions[i],
            Guard::Gap(i) => self.gaps[i],
            Guard::Foot { entry, .. } => self.feet[entry],
            Guard::Condition(_) => f64::NAN,
        }
    }

    /// Distances of foot `k` from both ends of its bar.
    pub(super) fn margins(&self, k: usize) -> [f64; 2] {
        [self.feet[2 * k], self.feet[2 * k + 1]]
    }
}

/// The motion over one step, as the guards see it.
pub(crate) trait Motion {
    /// Values of the guards of these kinds at θ.
    fn sample(&self, theta: f64, kinds: Kinds, values: &mut Values);
    /// The difference of a condition's sides at θ, and the larger of them.
    fn difference(&self, theta: f64, condition: &Condition) -> (f64, f64);
}

/// A step of a phase.
pub(crate) struct StepView<'a, M: BarSystem, const N: usize> {
    pub(crate) phase: &'a Phase<M, f64, N>,
    pub(crate) scene: &'a Scene<M>,
    pub(crate) dense: &'a Dense<f64, N>,
}

impl<M: BarSystem, const N: usize> Motion for StepView<'_, M, N> {
    fn sample(&self, theta: f64, kinds: Kinds, values: &mut Values) {
        let constants = &self.scene.constants;
        let reduced = self.dense.at(theta);
        if kinds.reactions {
            let reactions = (self.phase.reactions)(constants, self.phase.set, &reduced);
            values.reactions.copy_from_slice(reactions.as_ref());
        }
        if !(kinds.gaps || kinds.feet) {
            return;
        }
        let state = (self.phase.embed)(constants, &reduced);
        if kinds.gaps {
            let contacts = values.gaps.len();
            values.gaps.copy_from_slice(&M::kernel(constants, &state).gap()[..contacts]);
        }
        if kinds.feet {
            let feet = M::feet(constants, &state);
            values.feet[..feet.as_ref().len()].copy_from_slice(feet.as_ref());
        }
    }

    fn difference(&self, theta: f64, condition: &Condition) -> (f64, f64) {
        let t = self.dense.t0 + theta * self.dense.h;
        let moment = At::new(self.phase, &self.scene.constants, t, self.dense.at(theta));
        condition.difference(self.scene, &moment)
    }
}
