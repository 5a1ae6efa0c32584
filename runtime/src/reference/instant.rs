//! A phase at one time, in double-double.

use super::flow::{Flow, Ground};
use crate::model::{BarSystem, ContactSet, Energy, KernelView};
use crate::output::{Condition, Unsupported};
use crate::scalar::DoubleDouble;
use crate::watch::Guard;

/// A state of a phase at a time.
pub(crate) struct Instant<'a, M: BarSystem> {
    ground: &'a Ground<M>,
    pub(crate) t: DoubleDouble,
    /// The full state.
    pub(crate) state: M::State<DoubleDouble>,
    flow: &'a dyn Flow<M>,
    set: ContactSet,
    reduced: &'a [DoubleDouble],
}

impl<'a, M: BarSystem> Instant<'a, M> {
    pub(super) fn new(
        ground: &'a Ground<M>,
        (flow, set): (&'a dyn Flow<M>, ContactSet),
        t: DoubleDouble,
        reduced: &'a [DoubleDouble],
    ) -> Self {
        Self { ground, t, state: flow.embed(reduced), flow, set, reduced }
    }

    /// The value of a guard.
    pub(super) fn guard(&self, guard: Guard, conditions: &[Condition]) -> Result<DoubleDouble, Unsupported> {
        Ok(match guard {
            Guard::Reaction(i) => self.reactions().as_ref()[i],
            Guard::Gap(i) => self.gap(i),
            Guard::Foot { entry, .. } => M::feet(&self.ground.constants, &self.state).as_ref()[entry],
            Guard::Condition(k) => return conditions[k].precise_difference(self),
        })
    }

    pub(crate) fn parameter(&self, i: usize) -> f64 {
        self.ground.parameters[i]
    }

    pub(crate) fn reactions(&self) -> M::Reactions<DoubleDouble> {
        self.flow.reactions(self.reduced)
    }

    pub(crate) fn energy(&self) -> Energy<DoubleDouble> {
        self.flow.energy(self.reduced)
    }

    pub(crate) fn gap(&self, contact: usize) -> DoubleDouble {
        M::kernel(&self.ground.constants, &self.state).gap()[contact]
    }

    pub(crate) fn points(&self) -> M::Points<DoubleDouble> {
        M::points(&self.ground.constants, &self.state)
    }

    pub(crate) fn accelerations(&self) -> M::Accelerations<DoubleDouble> {
        self.ground.solve(self.set, &self.state).0
    }

    pub(crate) fn quantity(&self, entry: usize) -> DoubleDouble {
        let (accelerations, multipliers) = self.ground.solve(self.set, &self.state);
        M::quantity(&self.ground.constants, entry, &self.state, &accelerations, &multipliers)
    }
}
