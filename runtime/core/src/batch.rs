//! The equations of one phase for many states at once.

use crate::model::{Array, BarSystem, ClosedForm, ContactSet, Form, Phase, PhaseVisitor};
use crate::scalar::Lanes;

/// States side by side: twice as many as a vector holds, as elimination is a chain of operations that wait for one another.
pub type Side = Lanes<2>;

/// The right-hand side of a phase in closed form, for [`Side::COUNT`] states side by side. The bits of each do not depend on the
/// others; they are those of one state alone, but for chains from six bars on, which are computed in another order.
pub struct Batch<M: BarSystem> {
    constants: M::Constants<Side>,
    evaluate: Evaluate<M>,
}

type Evaluate<M> = fn(
    &<M as BarSystem>::Constants<Side>,
    &[<M as BarSystem>::State<Side>],
    &mut [<M as BarSystem>::Accelerations<Side>],
);

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
        let evaluate =
            M::phase(set, Form::Closed, Select).ok_or_else(|| NoClosedForm { closed: labels() })?;
        Ok(Self { constants: model.constants(), evaluate })
    }

    /// Accelerations of the coordinates that the phase keeps, in their order and first; zero after them. `states` are full,
    /// coordinates, then rates, then the time if the equations depend on it, [`Side::COUNT`] in each, and satisfy the closed
    /// contacts. Of slices that are not equally long, the rest is left alone.
    pub fn reduced_accelerations(
        &self,
        states: &[M::State<Side>],
        accelerations: &mut [M::Accelerations<Side>],
    ) {
        (self.evaluate)(&self.constants, states, accelerations);
    }

    /// States side by side; the last is repeated where [`Side::COUNT`] does not divide their number.
    pub fn pack(states: &[M::State<f64>]) -> Vec<M::State<Side>> {
        let packed = |chunk: &[M::State<f64>]| {
            let lane = |lane: usize| chunk[lane.min(chunk.len() - 1)].as_ref();
            M::State::from_fn(|i| Side::from_fn(|k| lane(k)[i]))
        };
        states.chunks(Side::COUNT).map(packed).collect()
    }
}

struct Select;

impl<M: BarSystem> PhaseVisitor<M, f64> for Select {
    type Output = Option<Evaluate<M>>;

    fn visit<const N: usize>(self, _: Phase<M, f64, N>) -> Self::Output {
        None
    }

    fn visit_closed<const N: usize, Q: ClosedForm<M, N>>(self, _: Phase<M, f64, N>) -> Self::Output {
        Some(evaluate::<M, Q, N>)
    }
}

fn evaluate<M: BarSystem, Q: ClosedForm<M, N>, const N: usize>(
    constants: &M::Constants<Side>,
    states: &[M::State<Side>],
    accelerations: &mut [M::Accelerations<Side>],
) {
    for (state, accelerations) in states.iter().zip(accelerations) {
        let derivative = Q::derivative(constants, &Q::restrict(state));
        let (kept, rest) = accelerations.as_mut().split_at_mut(Q::RATES);
        kept.copy_from_slice(&derivative[Q::COORDINATES..][..Q::RATES]);
        rest.fill(Side::splat(0.0));
    }
}
