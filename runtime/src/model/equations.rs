//! The full equations at a state.

use super::ContactSet;
use crate::kernel;
use crate::scalar::Scalar;

/// The full equations at a state: `M a = f + Jᵀ λ`, and `g`, `J a + b = g̈` for each row.
///
/// `N` coordinates, `C` rows (contacts, then joints), `D = N + C`.
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
    /// b = J̇ u.
    pub bias: [S; C],
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
    /// a of `M a = f + Jᵀ λ`, `J a = −b` over the rows of `set` and the joints, the rows from `contacts` on.
    fn accelerations(&self, contacts: usize, set: ContactSet, accelerations: &mut [S])
    where
        S: Scalar;
    /// The least change d in the mass metric with `J d = −r` over the same rows: `M d = Jᵀ μ`.
    fn correction(&self, contacts: usize, set: ContactSet, residual: impl Fn(usize) -> S, change: &mut [S])
    where
        S: Scalar;
}

impl<S: Copy, const N: usize, const C: usize, const D: usize> KernelView<S> for Kernel<S, N, C, D> {
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
    fn accelerations(&self, contacts: usize, set: ContactSet, accelerations: &mut [S])
    where
        S: Scalar,
    {
        accelerations.copy_from_slice(&kernel::accelerations(self, contacts, set));
    }
    fn correction(&self, contacts: usize, set: ContactSet, residual: impl Fn(usize) -> S, change: &mut [S])
    where
        S: Scalar,
    {
        let system = Self { force: [S::ZERO; N], bias: core::array::from_fn(residual), ..*self };
        change.copy_from_slice(&kernel::accelerations(&system, contacts, set));
    }
}
