//! The equations solved without naming their dimensions.

use super::{Room, correct_in, solution};
use crate::model::{ContactSet, Kernel, KernelView, Layout};
use crate::scalar::{Real, Scalar};

impl<S: Real, const N: usize, const C: usize, const D: usize> KernelView<S> for Kernel<S, N, C, D> {
    fn mass(&self, i: usize) -> &[S] {
        &self.mass[i]
    }
    fn force(&self) -> &[S] {
        &self.force
    }
    fn gap(&self) -> &[S] {
        &self.gap
    }
    fn jacobian(&self, i: usize) -> &[S] {
        &self.jacobian[i]
    }
    fn bias(&self) -> &[S] {
        &self.bias
    }
    fn prescribed_gap_rate(&self) -> &[S] {
        &self.prescribed_gap_rate
    }
    fn friction(&self) -> &[S] {
        &self.friction
    }
    fn push(&mut self, row: usize, multiplier: S) {
        for (force, entry) in self.force.iter_mut().zip(&self.jacobian[row]) {
            *force = entry.mul_add(multiplier, *force);
        }
    }
    fn solve(&self, layout: &Layout, set: &ContactSet, accelerations: &mut [S], multipliers: &mut [S]) -> bool
    where
        S: Scalar,
    {
        match (accelerations.try_into(), multipliers.try_into()) {
            (Ok(accelerations), Ok(multipliers)) => solution(self, layout, set, accelerations, multipliers),
            _ => false,
        }
    }
    // One copy for all models of these dimensions.
    #[inline(never)]
    fn correction(&self, layout: &Layout, set: &ContactSet, residual: &dyn Fn(usize) -> S, change: &mut [S])
    where
        S: Scalar,
    {
        let mut room = Room::<S, C, D>::default();
        correct_in(room.workspace(), self, layout, set, residual, change);
    }
}
