//! The equations of one phase for many states at once.

use core::marker::PhantomData;

use crate::model::{Array, BarSystem, ClosedForm, ContactSet, Form, Phase, PhaseVisitor};
use crate::scalar::dispatch::{ForVector, widest};
use crate::scalar::{Inside, Lanes, Vector};

/// States side by side: twice as many as a vector holds, as elimination is a chain of operations
/// that wait for one another.
pub type BatchLanes = Lanes<2>;

/// The right-hand side of a phase in closed form, for [`BatchLanes::COUNT`] states side by side, by
/// the widest instructions that the processor has. The bits of each do not depend on the others;
/// where the program is compiled for the same instructions they are those of one state alone, but
/// for chains from six bars on, which are computed in another order.
pub struct Batch<M: BarSystem>(Box<dyn Evaluate<M>>);

trait Evaluate<M: BarSystem>: Send + Sync {
    fn evaluate(&self, states: &[M::State<BatchLanes>], accelerations: &mut [M::Accelerations<BatchLanes>]);
}

/// A phase that is not solved in closed form, so that there is no batch of it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the phase in which {} are closed has no closed form", closed.join(", "))]
pub struct NoClosedForm {
    /// Labels of the contacts that are closed in it.
    pub closed: Vec<&'static str>,
}

impl<M: BarSystem> Batch<M> {
    /// The phase in which these contacts, and no others, are closed.
    ///
    /// # Errors
    /// It has no closed form.
    pub fn new(model: &M, set: ContactSet) -> Result<Self, NoClosedForm> {
        let labels = || set.iter().map(|contact| M::LAYOUT.contacts[contact].label).collect();
        let found = widest(Find { model, set });
        found.map(Self).ok_or_else(|| NoClosedForm { closed: labels() })
    }

    /// Accelerations of the coordinates that the phase keeps, in their order and first; zero after
    /// them. `states` are full, coordinates, then rates, then the time if the equations depend on
    /// it, [`BatchLanes::COUNT`] in each, and satisfy the closed contacts. Of slices that are not
    /// equally long, the rest is left alone.
    pub fn reduced_accelerations(
        &self,
        states: &[M::State<BatchLanes>],
        accelerations: &mut [M::Accelerations<BatchLanes>],
    ) {
        self.0.evaluate(states, accelerations);
    }

    /// States side by side; the last is repeated where [`BatchLanes::COUNT`] does not divide their
    /// number.
    pub fn pack(states: &[M::State<f64>]) -> Vec<M::State<BatchLanes>> {
        let packed = |chunk: &[M::State<f64>]| {
            let lane = |lane: usize| chunk[lane.min(chunk.len() - 1)].as_ref();
            M::State::from_fn(|i| BatchLanes::from_fn(|k| lane(k)[i]))
        };
        states.chunks(BatchLanes::COUNT).map(packed).collect()
    }
}

struct Find<'a, M> {
    model: &'a M,
    set: ContactSet,
}

impl<M: BarSystem> ForVector for Find<'_, M> {
    type Output = Option<Box<dyn Evaluate<M>>>;

    fn with<X: Vector>(self) -> Self::Output {
        M::phase(self.set, Form::Reduced, Select::<M, X>(&self, PhantomData))
    }
}

struct Select<'a, M, X>(&'a Find<'a, M>, PhantomData<X>);

impl<M: BarSystem, X: Vector> PhaseVisitor<M, f64> for Select<'_, M, X> {
    type Output = Option<Box<dyn Evaluate<M>>>;

    fn visit<const N: usize>(self, _: Phase<M, f64, N>) -> Self::Output {
        None
    }

    fn visit_closed<const N: usize, Q: ClosedForm<M, N>>(self, _: Phase<M, f64, N>) -> Self::Output {
        let constants = M::constants_from(self.0.model.parameters().as_ref(), &self.0.set);
        Some(Box::new(Closed::<M, Q, X, N> { constants, form: PhantomData }))
    }
}

/// Constants in the vectors that have been found.
struct Closed<M: BarSystem, Q, X: Vector, const N: usize> {
    constants: M::Constants<Lanes<2, X>>,
    form: PhantomData<fn() -> Q>,
}

impl<M: BarSystem, Q: ClosedForm<M, N>, X: Vector, const N: usize> Evaluate<M> for Closed<M, Q, X, N> {
    fn evaluate(&self, states: &[M::State<BatchLanes>], accelerations: &mut [M::Accelerations<BatchLanes>]) {
        X::inside(All { closed: self, states, accelerations });
    }
}

/// All states.
struct All<'a, M: BarSystem, Q, X: Vector, const N: usize> {
    closed: &'a Closed<M, Q, X, N>,
    states: &'a [M::State<BatchLanes>],
    accelerations: &'a mut [M::Accelerations<BatchLanes>],
}

impl<M: BarSystem, Q: ClosedForm<M, N>, X: Vector, const N: usize> Inside for All<'_, M, Q, X, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { closed, states, accelerations } = self;
        for (state, accelerations) in states.iter().zip(accelerations) {
            one::<M, Q, X, N>(&closed.constants, state, accelerations);
        }
    }
}

#[inline(always)]
fn one<M: BarSystem, Q: ClosedForm<M, N>, X: Vector, const N: usize>(
    constants: &M::Constants<Lanes<2, X>>,
    state: &M::State<BatchLanes>,
    accelerations: &mut M::Accelerations<BatchLanes>,
) {
    let Some(state) = M::State::of_slice(X::view(state.as_ref())) else { return };
    let derivative = Q::derivative(constants, &Q::restrict(state));
    let (kept, rest) = accelerations.as_mut().split_at_mut(Q::RATES);
    X::view_mut(kept).copy_from_slice(&derivative[Q::COORDINATES..][..Q::RATES]);
    rest.fill(BatchLanes::splat(0.0));
}
