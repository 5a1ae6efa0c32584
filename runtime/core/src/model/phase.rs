//! The equations of one contact set.

use super::{BarSystem, ContactSet, KernelSeries, PhaseSeries};
use crate::scalar::{Real, Scalar};

/// How a phase is integrated.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Form {
    /// The closed contacts are eliminated in closed form; the state is reduced and cannot drift.
    Closed,
    /// All coordinates are kept; multipliers hold the contacts and each accepted step is projected.
    Projected,
}

/// Kinetic and potential energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy<S> {
    /// T.
    pub kinetic: S,
    /// V.
    pub potential: S,
}

impl Energy<f64> {
    /// What the sum has gained since another; the parts are compared first, so that large ones do not hide it.
    pub fn gained_since(&self, before: &Self) -> f64 {
        (self.kinetic - before.kinetic) + (self.potential - before.potential)
    }
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
    /// How many entries are rates; they follow. A last entry is the time, if the equations depend on it.
    pub rates: usize,
    /// Time derivative of the reduced state.
    pub derivative: InSet<M, S, [S; N], [S; N]>,
    /// Reaction of every contact, zero where open, then the friction forces.
    pub reactions: InSet<M, S, [S; N], M::Reactions<S>>,
    /// The full state of a reduced one.
    pub embed: OfState<M, S, [S; N], M::State<S>>,
    /// The reduced state of a full one that satisfies the closed contacts.
    pub restrict: fn(&M::State<S>) -> [S; N],
    /// Whether reactions, gaps, slip velocities and feet are affine functions of the reduced state, with constant coefficients.
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
    /// Called instead with a phase that keeps all coordinates, where the Taylor series of the full equations are `Q`; what does not
    /// use them need not say so, and nothing of them is compiled.
    fn visit_projected<const N: usize, Q: KernelSeries<M, N>>(self, phase: Phase<M, S, N>) -> Self::Output
    where
        Self: Sized,
    {
        self.visit(phase)
    }
    /// Called instead with a phase in closed form, whose equations on any number are `Q`; what does not use them need not say
    /// so.
    fn visit_closed<const N: usize, Q: ClosedForm<M, N>>(self, phase: Phase<M, S, N>) -> Self::Output
    where
        Self: Sized,
    {
        self.visit(phase)
    }
    /// Called instead with a phase in closed form, whose Taylor series are `Q`; what does not use them need not say so, and
    /// nothing of them is compiled.
    fn visit_series<const N: usize, Q: PhaseSeries<M, N>>(self, phase: Phase<M, S, N>) -> Self::Output
    where
        Self: Sized,
    {
        self.visit_closed::<N, Q>(phase)
    }
}

/// The equations of a closed form, most of them on numbers that need no order, as those side by side; implemented by the
/// derive macro, one type for each closed form.
pub trait ClosedForm<M: BarSystem, const N: usize>: 'static {
    /// How many entries of the reduced state are coordinates; they come first.
    const COORDINATES: usize;
    /// How many entries are rates; they follow.
    const RATES: usize;
    /// The derivative of a reduced state.
    fn derivative<S: Real>(constants: &M::Constants<S>, state: &[S; N]) -> [S; N];
    /// The reduced state of a full one.
    fn restrict<S: Real>(state: &M::State<S>) -> [S; N];
    /// The least pivot of the elimination, relative to its natural size; 1 where there is none.
    fn pivot<S: Scalar>(_: &M::Constants<S>, _: &[S; N]) -> S {
        S::ratio(1, 1)
    }
    /// T and V with the eliminated coordinates substituted, so that no digits cancel.
    fn energy<S: Real>(constants: &M::Constants<S>, state: &[S; N]) -> Energy<S>;
    /// Puts the constants of one model, one by one, into those of another scalar: of many models, say, each in its place.
    fn fill<S: Real, T: Real>(constants: &mut M::Constants<S>, of: &M::Constants<T>, put: impl Fn(&mut S, T));
}

/// The least magnitude among pivots relative to their natural sizes; 1 without pivots.
pub fn least<S: Scalar, const P: usize>(pivots: [S; P]) -> S {
    pivots.into_iter().map(S::abs).fold(S::ratio(1, 1), |least, p| if p < least { p } else { least })
}
