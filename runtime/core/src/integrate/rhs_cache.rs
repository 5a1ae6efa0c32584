//! f at the start of a step, and the first step that it suggests.

use super::initial_step::initial_step;
use super::{StepError, StepState};
use crate::scalar::Scalar;

/// f at the state of a [`StepState`], kept until that is changed from outside.
pub(super) struct RhsCache<S, const N: usize>(Option<([S; N], u64)>);

impl<S: Scalar, const N: usize> RhsCache<S, N> {
    /// Not yet known.
    pub(super) const UNKNOWN: Self = Self(None);

    /// f at the state; an error if either is not finite.
    pub(super) fn get(
        &mut self,
        f: &impl Fn(&[S; N]) -> [S; N],
        step_state: &mut StepState<S, N>,
    ) -> Result<[S; N], StepError> {
        let slope = match self.0 {
            Some((slope, jumps)) if jumps == step_state.jumps() => slope,
            _ => {
                step_state.counts.evaluations += 1;
                f(&step_state.state)
            }
        };
        step_state.check(&slope)?;
        self.set(slope, step_state);
        Ok(slope)
    }

    /// Takes f at the state.
    pub(super) fn set(&mut self, slope: [S; N], step_state: &StepState<S, N>) {
        self.0 = Some((slope, step_state.jumps()));
    }
}

/// The next step, at first the one that f suggests for a method of this order.
pub(super) fn planned_step<S: Scalar, const N: usize>(
    f: &impl Fn(&[S; N]) -> [S; N],
    step_state: &mut StepState<S, N>,
    slope: &[S; N],
    order: f64,
) -> S {
    if let Some(h) = step_state.next {
        return h;
    }
    step_state.counts.evaluations += 1;
    let h = initial_step(f, &step_state.state, slope, &step_state.tolerance, order);
    step_state.begin(h)
}
