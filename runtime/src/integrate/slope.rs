//! f at the start of a step, and the first step that it suggests.

use super::initial_step::initial_step;
use super::{Progress, Rates, StepError};
use crate::scalar::Scalar;

/// f at the state of a [`Progress`], kept until that is changed from outside.
pub(super) struct Slope<S, const N: usize>(Option<([S; N], u64)>);

impl<S: Scalar, const N: usize> Slope<S, N> {
    /// Not yet known.
    pub(super) const UNKNOWN: Self = Self(None);

    /// f at the state; an error if either is not finite.
    pub(super) fn get(&mut self, f: Rates<S, N>, progress: &mut Progress<S, N>) -> Result<[S; N], StepError> {
        let slope = match self.0 {
            Some((slope, jumps)) if jumps == progress.jumps() => slope,
            _ => {
                progress.counts.evaluations += 1;
                f(&progress.state)
            }
        };
        progress.check(&slope)?;
        self.set(slope, progress);
        Ok(slope)
    }

    /// Takes f at the state.
    pub(super) fn set(&mut self, slope: [S; N], progress: &Progress<S, N>) {
        self.0 = Some((slope, progress.jumps()));
    }
}

/// The next step, at first the one that f suggests for a method of this order.
pub(super) fn planned_step<S: Scalar, const N: usize>(
    f: Rates<S, N>,
    progress: &mut Progress<S, N>,
    slope: &[S; N],
    order: f64,
) -> S {
    if let Some(h) = progress.next {
        return h;
    }
    progress.counts.evaluations += 1;
    let h = initial_step(f, &progress.state, slope, &progress.tolerance, order);
    progress.begin(h)
}
