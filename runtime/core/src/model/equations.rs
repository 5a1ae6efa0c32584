//! The full equations at a state.

use super::{ContactSet, Layout};
use crate::scalar::Scalar;

/// The full equations at a state: `M a = f + Jᵀ λ`, and `g`, `J a + b = g̈` for each row.
///
/// `N` coordinates, `C` rows (contacts, joints, tangents), `D = N + C`.
#[derive(Clone, Copy, Debug)]
pub struct Kernel<S, const N: usize, const C: usize, const D: usize> {
    /// M, symmetric.
    pub mass: [[S; N]; N],
    /// f = Q − h: generalised forces less velocity terms.
    pub force: [S; N],
    /// g.
    pub gap: [S; C],
    /// J = ∂g/∂q.
    pub jacobian: [[S; N]; C],
    /// b = J̇ u + ∂²g/∂t²: what g̈ is without accelerations.
    pub bias: [S; C],
    /// ∂g/∂t, so that ġ = J u + ∂g/∂t: not zero for prescribed motions.
    pub prescribed_gap_rate: [S; C],
    /// σμ of the slips of sliding contacts, zero elsewhere: the friction force is −σμ times the
    /// reaction.
    pub friction: [S; C],
}

/// Reads a [`Kernel`] without naming its dimensions.
pub trait KernelView<S> {
    /// Row `i` of M.
    fn mass(&self, i: usize) -> &[S];
    /// f.
    fn force(&self) -> &[S];
    /// g.
    fn gap(&self) -> &[S];
    /// Row `i` of J.
    fn jacobian(&self, i: usize) -> &[S];
    /// b.
    fn bias(&self) -> &[S];
    /// ∂g/∂t.
    fn prescribed_gap_rate(&self) -> &[S];
    /// σμ.
    fn friction(&self) -> &[S];
    /// Adds the force of a multiplier to f: `f + J_rowᵀ λ`.
    fn push(&mut self, row: usize, multiplier: S);
    /// a of `M a = f + Jᵀ λ`, `J a = −b` over the rows closed in `set`, and λ of every row, zero
    /// where open, the friction force for the slip of a sliding contact; whether λ is unique.
    fn solve(
        &self,
        layout: &Layout,
        set: &ContactSet,
        accelerations: &mut [S],
        multipliers: &mut [S],
    ) -> bool
    where
        S: Scalar;
    /// The least change d in the mass metric with `J d = −r` over the same rows: `M d = Jᵀ μ`.
    fn correction(&self, layout: &Layout, set: &ContactSet, residual: &dyn Fn(usize) -> S, change: &mut [S])
    where
        S: Scalar;
}
