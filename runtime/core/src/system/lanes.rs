//! Motions of a compiled model side by side, its type erased: one call for a step of all lanes.

use core::marker::PhantomData;

use super::arrays::array;
use crate::integrate::{Counts, Ended, LaneStepper, StepError, StepState, Tolerance, ToleranceError};
use crate::model::{BarSystem, ContactSet, Form, Layout, Phase, PhaseSeries, PhaseVisitor};
use crate::scalar::Lanes;
use crate::scalar::dispatch::{ForVector, Vector, widest};

/// Motions of one smooth phase at one relative tolerance by Taylor's method, at most
/// [`LANES`](crate::scalar::LANES) at once. The bits of one depend neither on its lane nor on the
/// others.
pub trait LaneGroup {
    /// Names of the model.
    fn layout(&self) -> &'static Layout;
    /// A lane without a motion.
    fn free(&self) -> Option<usize>;
    /// Whether no lane has a motion.
    fn is_empty(&self) -> bool;
    /// Puts a motion into a lane.
    ///
    /// # Errors
    /// An absolute tolerance that is not positive.
    fn enter(&mut self, lane: usize, start: &LaneStart<'_>) -> Result<(), ToleranceError>;
    /// One step of all; `ended` takes each motion that ends with it.
    fn step(&mut self, ended: &mut dyn FnMut(LaneEnd<'_>));
}

/// A motion that is to begin, at t = 0.
#[derive(Clone, Copy, Debug)]
pub struct LaneStart<'a> {
    /// Values of the model's parameters.
    pub parameters: &'a [f64],
    /// The full state.
    pub state: &'a [f64],
    /// The time at which it ends.
    pub end: f64,
    /// Absolute tolerance of each entry of the reduced state.
    pub absolute: &'a [f64],
    /// A guess at the first step, which may be many times too long or too short.
    pub first_step: f64,
}

/// A motion that has reached its end, or could not; its lane is free.
#[derive(Clone, Copy, Debug)]
pub struct LaneEnd<'a> {
    /// The lane.
    pub lane: usize,
    /// The time reached.
    pub t: f64,
    /// The reduced state there.
    pub reduced: &'a [f64],
    /// The work done.
    pub counts: Counts,
    /// Why it is not at its end.
    pub error: Option<StepError>,
}

/// Makes an empty group for motions of one model, with the parameters of any of them and a relative
/// tolerance > 0.
pub type LaneConstructor = fn(&[f64], f64) -> Option<Box<dyn LaneGroup>>;

/// The [`LaneConstructor`] of a compiled model. One with contacts, joints, switches or kinks has
/// none, and no code of it is compiled.
pub fn lanes<M: BarSystem>(parameters: &[f64], relative: f64) -> Option<Box<dyn LaneGroup>> {
    let watched = const {
        let Layout { contacts, joints, switches, kinks, .. } = M::LAYOUT;
        !contacts.is_empty() || !joints.is_empty() || !switches.is_empty() || !kinks.is_empty()
    };
    if watched {
        return None;
    }
    widest(Begin::<M> { parameters, relative, model: PhantomData })
}

struct Begin<'a, M> {
    parameters: &'a [f64],
    relative: f64,
    model: PhantomData<M>,
}

impl<M: BarSystem> ForVector for Begin<'_, M> {
    type Output = Option<Box<dyn LaneGroup>>;

    fn with<X: Vector>(self) -> Self::Output {
        M::phase(ContactSet::EMPTY, Form::Reduced, BeginWith::<M, X>(self, PhantomData))
    }
}

struct BeginWith<'a, M, X>(Begin<'a, M>, PhantomData<X>);

impl<M: BarSystem, X: Vector> PhaseVisitor<M, f64> for BeginWith<'_, M, X> {
    type Output = Option<Box<dyn LaneGroup>>;

    fn visit<const N: usize>(self, _: Phase<M, f64, N>) -> Self::Output {
        None
    }

    fn visit_series<const N: usize, Q: PhaseSeries<M, N>>(self, _: Phase<M, f64, N>) -> Self::Output {
        let Begin { parameters, relative, .. } = self.0;
        let constants = M::from_parameters(parameters).constants::<Lanes<1, X>>();
        let stepper = LaneStepper::<M, Q, X, N>::new(constants, relative);
        Some(Box::new(Group { relative, stepper }))
    }
}

struct Group<M: BarSystem, Q: PhaseSeries<M, N>, X: Vector, const N: usize> {
    relative: f64,
    stepper: LaneStepper<M, Q, X, N>,
}

impl<M: BarSystem, Q: PhaseSeries<M, N>, X: Vector, const N: usize> LaneGroup for Group<M, Q, X, N> {
    fn layout(&self) -> &'static Layout {
        M::LAYOUT
    }

    fn free(&self) -> Option<usize> {
        self.stepper.free()
    }

    fn is_empty(&self) -> bool {
        self.stepper.is_empty()
    }

    fn enter(&mut self, lane: usize, start: &LaneStart<'_>) -> Result<(), ToleranceError> {
        let absolute = core::array::from_fn(|i| start.absolute.get(i).copied().unwrap_or(f64::NAN));
        let tolerance = Tolerance::new(self.relative, absolute)?;
        let constants = M::from_parameters(start.parameters).constants();
        let step_state = StepState::new(tolerance, 0.0, Q::restrict(&array(start.state))).with_end(start.end);
        self.stepper.enter(lane, step_state, &constants, start.first_step);
        Ok(())
    }

    fn step(&mut self, ended: &mut dyn FnMut(LaneEnd<'_>)) {
        for Ended { lane, step_state, error } in self.stepper.step().into_iter().flatten() {
            let (t, reduced, counts) = (step_state.time(), &step_state.state()[..], step_state.counts());
            ended(LaneEnd { lane, t, reduced, counts, error });
        }
    }
}
