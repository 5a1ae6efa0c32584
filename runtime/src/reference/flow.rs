//! The motion of one phase in double-double, by the emitted generic code, with the size of its state erased.

use super::extrapolation::System;
use crate::model::{Array, BarSystem, ContactSet, Energy, Form, KernelView, Phase, PhaseVisitor};
use crate::project::project;
use crate::scalar::{DoubleDouble, Real, Scalar};

/// A phase of a model.
pub(super) trait Flow<M: BarSystem>: System {
    /// The phase as a system of equations.
    fn system(&self) -> &dyn System;
    /// Natural size of each entry of the reduced state.
    fn units(&self) -> Vec<f64>;
    /// The reduced state of a full one, on the constraints.
    fn restrict(&self, state: M::State<DoubleDouble>) -> Vec<DoubleDouble>;
    /// The full state of a reduced one.
    fn embed(&self, y: &[DoubleDouble]) -> M::State<DoubleDouble>;
    /// Reactions of all contacts.
    fn reactions(&self, y: &[DoubleDouble]) -> M::Reactions<DoubleDouble>;
    /// T and V.
    fn energy(&self, y: &[DoubleDouble]) -> Energy<DoubleDouble>;
}

/// The constants in double-double, and the natural units of a full state.
pub(super) struct Ground<M: BarSystem> {
    pub(super) constants: M::Constants<DoubleDouble>,
    pub(super) parameters: Vec<f64>,
    pub(super) restitution: Vec<f64>,
    pub(super) units: Vec<f64>,
    pub(super) length: f64,
    pub(super) time: f64,
}

impl<M: BarSystem> Ground<M> {
    /// The phase of a contact set.
    pub(super) fn flow(&self, set: ContactSet, form: Form) -> Box<dyn Flow<M> + '_> {
        M::phase(set, form, Erase { ground: self })
    }

    /// Accelerations and multipliers of all rows at a full state.
    pub(super) fn solve(
        &self,
        set: ContactSet,
        state: &M::State<DoubleDouble>,
    ) -> (M::Accelerations<DoubleDouble>, M::Multipliers<DoubleDouble>) {
        let mut accelerations = M::Accelerations::from_fn(|_| DoubleDouble::ZERO);
        let mut multipliers = M::Multipliers::from_fn(|_| DoubleDouble::ZERO);
        let kernel = M::kernel(&self.constants, state);
        kernel.solve(M::LAYOUT, set, accelerations.as_mut(), multipliers.as_mut());
        (accelerations, multipliers)
    }
}

struct Erase<'a, M: BarSystem> {
    ground: &'a Ground<M>,
}

impl<'a, M: BarSystem> PhaseVisitor<M, DoubleDouble> for Erase<'a, M> {
    type Output = Box<dyn Flow<M> + 'a>;

    fn visit<const N: usize>(self, phase: Phase<M, DoubleDouble, N>) -> Self::Output {
        Box::new(Erased { ground: self.ground, phase })
    }
}

struct Erased<'a, M: BarSystem, const N: usize> {
    ground: &'a Ground<M>,
    phase: Phase<M, DoubleDouble, N>,
}

impl<M: BarSystem, const N: usize> Erased<'_, M, N> {
    fn project(&self, state: &mut M::State<DoubleDouble>) {
        if self.phase.form == Form::Projected {
            let mut work = vec![DoubleDouble::ZERO; M::LAYOUT.coordinates.len()];
            project::<M, _>(&self.ground.constants, self.phase.set, state, self.ground.length, &mut work);
        }
    }
}

impl<M: BarSystem, const N: usize> System for Erased<'_, M, N> {
    fn slope(&self, y: &[DoubleDouble], slope: &mut [DoubleDouble]) {
        slope.copy_from_slice(&(self.phase.derivative)(&self.ground.constants, self.phase.set, &sized(y)));
    }

    fn amend(&self, y: &mut [DoubleDouble]) {
        if self.phase.form == Form::Projected {
            let mut state = self.embed(y);
            self.project(&mut state);
            y.copy_from_slice(&(self.phase.restrict)(&state));
        }
    }
}

impl<M: BarSystem, const N: usize> Flow<M> for Erased<'_, M, N> {
    fn system(&self) -> &dyn System {
        self
    }

    fn units(&self) -> Vec<f64> {
        let units = M::State::from_fn(|i| DoubleDouble::from_f64(self.ground.units[i]));
        (self.phase.restrict)(&units).map(DoubleDouble::to_f64).to_vec()
    }

    fn restrict(&self, mut state: M::State<DoubleDouble>) -> Vec<DoubleDouble> {
        self.project(&mut state);
        (self.phase.restrict)(&state).to_vec()
    }

    fn embed(&self, y: &[DoubleDouble]) -> M::State<DoubleDouble> {
        (self.phase.embed)(&self.ground.constants, &sized(y))
    }

    fn reactions(&self, y: &[DoubleDouble]) -> M::Reactions<DoubleDouble> {
        (self.phase.reactions)(&self.ground.constants, self.phase.set, &sized(y))
    }

    fn energy(&self, y: &[DoubleDouble]) -> Energy<DoubleDouble> {
        (self.phase.energy)(&self.ground.constants, &sized(y))
    }
}

/// A reduced state with its size; entries that are missing are not numbers.
fn sized<const N: usize>(y: &[DoubleDouble]) -> [DoubleDouble; N] {
    core::array::from_fn(|i| y.get(i).copied().unwrap_or_else(|| DoubleDouble::from_f64(f64::NAN)))
}
