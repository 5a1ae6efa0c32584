//! The equations of one contact set.

use super::{BarSystem, ClosedForm, ContactSet, KernelSeries, PhaseSeries};
use crate::scalar::{Real, Scalar};

/// How a phase is integrated.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Form {
    /// The closed contacts are eliminated in closed form; the state is reduced and cannot drift.
    Reduced,
    /// All coordinates are kept; multipliers hold the contacts and each accepted step is projected.
    Multipliers,
}

/// A function of a reduced state in a contact set.
pub type InSet<M, S, State, Result> = fn(&<M as BarSystem>::Constants<S>, &ContactSet, &State) -> Result;

/// A function of a reduced state.
pub type OfState<M, S, State, Result> = fn(&<M as BarSystem>::Constants<S>, &State) -> Result;

/// The equations of one contact set: a first-order system in the reduced state `[S; N]`,
/// coordinates, then rates.
pub struct Phase<M: BarSystem, S: Real, const N: usize> {
    /// The closed contacts.
    pub set: ContactSet,
    /// Closed form or projected.
    pub form: Form,
    /// How many entries of the reduced state are coordinates; they come first.
    pub coordinates: usize,
    /// How many entries are rates; they follow. A last entry is the time, if the equations depend
    /// on it.
    pub rates: usize,
    /// Time derivative of the reduced state.
    pub derivative: InSet<M, S, [S; N], [S; N]>,
    /// Reaction of every contact, zero where open, then the friction forces.
    pub reactions: InSet<M, S, [S; N], M::Reactions<S>>,
    /// The full state of a reduced one.
    pub embed: OfState<M, S, [S; N], M::State<S>>,
    /// The reduced state of a full one that satisfies the closed contacts.
    pub restrict: fn(&M::State<S>) -> [S; N],
    /// Whether reactions, gaps, slip velocities and feet are affine functions of the reduced state,
    /// with constant coefficients.
    pub affine: bool,
}

impl<M: BarSystem, S: Real, const N: usize> Clone for Phase<M, S, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: BarSystem, S: Real, const N: usize> Copy for Phase<M, S, N> {}

/// Receives the phase that [`BarSystem::phase`] selects, with its dimension as a constant.
pub trait PhaseVisitor<M: BarSystem, S: Scalar> {
    /// What the visit returns.
    type Output;
    /// Called once with the selected phase.
    fn visit<const N: usize>(self, phase: Phase<M, S, N>) -> Self::Output;
    /// Called instead with a phase that keeps all coordinates, where the Taylor series of the full
    /// equations are `Q`; what does not use them need not say so, and nothing of them is compiled.
    fn visit_projected<const N: usize, Q: KernelSeries<M, N>>(self, phase: Phase<M, S, N>) -> Self::Output
    where
        Self: Sized,
    {
        self.visit(phase)
    }
    /// Called instead with a phase in closed form, whose equations on any number are `Q`; what does
    /// not use them need not say so.
    fn visit_closed<const N: usize, Q: ClosedForm<M, N>>(self, phase: Phase<M, S, N>) -> Self::Output
    where
        Self: Sized,
    {
        self.visit(phase)
    }
    /// Called instead with a phase in closed form, whose Taylor series are `Q`; what does not use
    /// them need not say so, and nothing of them is compiled.
    fn visit_series<const N: usize, Q: PhaseSeries<M, N>>(self, phase: Phase<M, S, N>) -> Self::Output
    where
        Self: Sized,
    {
        self.visit_closed::<N, Q>(phase)
    }
}
