//! Values of guards within a step.

use super::Guard;
use crate::integrate::{Dense, Guards};
use crate::model::{BarSystem, KernelView, Phase};
use crate::moment::{At, Scene};
use crate::output::{Condition, Known, Sides};

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
    /// The series of a guard other than a condition, Σ cₖ θᵏ, if the method has it.
    fn series(&self, guard: Guard) -> Option<&[f64]>;
    /// The series of a condition's sides, if they follow from those of what the method has.
    fn sides(&self, condition: &Condition) -> Option<Sides>;
}

/// A step of a phase.
pub(crate) struct StepView<'a, M: BarSystem, const N: usize> {
    pub(crate) phase: &'a Phase<M, f64, N>,
    pub(crate) scene: &'a Scene<M>,
    pub(crate) dense: &'a Dense<f64, N>,
    /// The method's own series of the guards.
    pub(crate) guards: Option<Guards<'a>>,
    /// Where the phase has each entry of the full state, if it has it.
    pub(crate) places: &'a [Option<usize>],
}

impl<'a, M: BarSystem, const N: usize> StepView<'a, M, N> {
    /// A step of which no more is known than its dense output.
    pub(crate) fn new(phase: &'a Phase<M, f64, N>, scene: &'a Scene<M>, dense: &'a Dense<f64, N>) -> Self {
        Self { phase, scene, dense, guards: None, places: &[] }
    }
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

    fn series(&self, guard: Guard) -> Option<&[f64]> {
        let guards = self.guards?;
        Some(match guard {
            Guard::Reaction(i) => guards.reaction(i),
            Guard::Gap(i) => guards.gap(i),
            Guard::Foot { entry, .. } => guards.foot(entry / 2, entry % 2),
            Guard::Condition(_) => return None,
        })
    }

    fn sides(&self, condition: &Condition) -> Option<Sides> {
        let guards = self.guards?;
        let powers = self.dense.powers()?;
        let n = M::LAYOUT.coordinates.len();
        condition.sides(&self.scene.parameters, &|known, terms| match known {
            Known::Coordinate { index, order } => {
                let place = self.places.get(index + order * n).copied().flatten()?;
                powers.iter().zip(terms).for_each(|(c, term)| *term = c[place]);
                Some(())
            }
            Known::Reaction(contact) => copy(guards.reaction(contact), terms),
            Known::Gap(contact) => copy(guards.gap(contact), terms),
            Known::Time => {
                (terms[0], terms[1]) = (self.dense.t0, self.dense.h);
                Some(())
            }
        })
    }
}

fn copy(series: &[f64], terms: &mut [f64]) -> Option<()> {
    series.iter().zip(terms).for_each(|(c, term)| *term = *c);
    Some(())
}
