//! A compiled model as a [`System`].

use std::sync::Arc;

use super::arrays::array;
use super::{Equations, PhaseEquations, System};
use crate::hinge;
use crate::model::{Array, BarSystem, ContactSet, Energy, Form, KernelView, Layout, SlipState};
use crate::project::project;
use crate::scalar::{Real, Scalar};

/// The constants of a model's equations on numbers `S`.
pub(super) struct Lifted<M: BarSystem, S: Real> {
    pub(super) constants: M::Constants<S>,
    /// From which constants of another scalar or of sliding contacts can be made.
    pub(super) parameters: M::Parameters<S>,
}

impl<M: BarSystem, S: Real> Lifted<M, S> {
    pub(super) fn new(model: &M) -> Self {
        let own = model.parameters();
        Self::with(Array::from_fn(|i| S::from_f64(own.as_ref()[i])))
    }

    /// With these values of its parameters.
    pub(super) fn with(parameters: M::Parameters<S>) -> Self {
        Self { constants: M::constants_of(&parameters, &ContactSet::EMPTY), parameters }
    }

    /// The constants with the senses of the contacts that slide in a set; none where those here
    /// hold.
    pub(super) fn sliding(&self, set: &ContactSet) -> Option<M::Constants<S>> {
        let slides = const { !M::LAYOUT.frictions.is_empty() } && M::LAYOUT.sliding(set).next().is_some();
        slides.then(|| M::constants_of(&self.parameters, set))
    }
}

/// A scalar that compiled models are lifted on; with `f64` go Taylor series and Jacobians.
pub(super) trait Liftable: Scalar {
    fn lift<M: BarSystem>(
        system: Arc<Lifted<M, Self>>,
        set: ContactSet,
        form: Form,
    ) -> Arc<dyn PhaseEquations<Self>>;
}

impl<M: BarSystem, S: Liftable> System<S> for Lifted<M, S> {
    fn layout(&self) -> &'static Layout {
        M::LAYOUT
    }

    fn equations(&self, state: &[S]) -> Equations<S> {
        Equations::from_kernel(&M::kernel(&self.constants, &array(state)))
    }

    fn gaps(&self, state: &[S], gaps: &mut [S]) {
        let count = gaps.len();
        gaps.copy_from_slice(&M::kernel(&self.constants, &array(state)).gap()[..count]);
    }

    fn solve(&self, state: &[S], set: ContactSet, accelerations: &mut [S], multipliers: &mut [S]) -> bool {
        let sliding = self.sliding(&set);
        let constants = sliding.as_ref().unwrap_or(&self.constants);
        if const { M::LAYOUT.has_hinges() } {
            return hinge::solution::<M, S>(constants, &set, &array(state), accelerations, multipliers);
        }
        M::kernel(constants, &array(state)).solve(M::LAYOUT, &set, accelerations, multipliers)
    }

    fn correction(&self, state: &[S], set: ContactSet, residual: &[S], change: &mut [S]) {
        M::kernel(&self.constants, &array(state)).correction(M::LAYOUT, &set, &|row| residual[row], change);
    }

    fn project(&self, set: ContactSet, state: &mut [S], length: f64) {
        let mut projected = array(state);
        let mut work = M::Accelerations::from_fn(|_| S::ZERO);
        project::<M, S>(&self.constants, &set, &mut projected, length, work.as_mut());
        state.copy_from_slice(projected.as_ref());
    }

    fn energy(&self, state: &[S]) -> Energy<S> {
        M::energy(&self.constants, &array(state))
    }

    fn points(&self, state: &[S], points: &mut [S]) {
        points.copy_from_slice(M::points(&self.constants, &array(state)).as_ref());
    }

    fn feet(&self, state: &[S], feet: &mut [S]) {
        feet.copy_from_slice(M::feet(&self.constants, &array(state)).as_ref());
    }

    fn kinks(&self, state: &[S], kinks: &mut [S]) {
        M::kinks(&self.constants, &array(state), kinks);
    }

    fn slips(&self, state: &[S], slips: &mut [SlipState<S>]) {
        M::slips(&self.constants, &array(state), slips);
    }

    fn quantity(&self, entry: usize, state: &[S], accelerations: &[S], multipliers: &[S]) -> S {
        M::quantity(&self.constants, entry, &array(state), &array(accelerations), &array(multipliers))
    }

    fn phase(self: Arc<Self>, set: ContactSet, form: Form) -> Arc<dyn PhaseEquations<S>> {
        let system = match self.sliding(&set) {
            None => self,
            Some(constants) => Arc::new(Self { constants, parameters: self.parameters }),
        };
        S::lift(system, set, form)
    }
}
