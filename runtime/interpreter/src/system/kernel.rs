//! The full equations at a state.

use liftoff_core::kernel::{Workspace, solve_in, write_mass};
use liftoff_core::model::{ContactSet, KernelView, Layout};

use super::full::{FullCode, MassForm};
use crate::pool::{Lent, Number};

/// What code has computed of the equations: f, g, b, ∂g/∂t, σμ, J, M.
pub(super) struct Kernel<S: Number> {
    values: Lent<S>,
    n: usize,
    rows: usize,
}

impl<S: Number> Kernel<S> {
    pub fn at(code: &FullCode, constants: &[S], state: &[S]) -> Self {
        let (n, rows) = (code.coordinates, code.rows);
        let before = n + (4 + n) * rows;
        let mut values = Lent::new(before + n * n);
        match &code.mass {
            MassForm::Entries => code.kernel.evaluate(constants, &[state], &mut values),
            MassForm::Paths(parents) => {
                let mut computed = Lent::new(before + 5 * n);
                code.kernel.evaluate(constants, &[state], &mut computed);
                values[..before].copy_from_slice(&computed[..before]);
                let mass = &mut values[before..];
                mass.fill(S::ZERO);
                let (vectors, own) = computed[before..].split_at(4 * n);
                let (reach, moments) = vectors.as_chunks().0.split_at(n);
                write_mass(parents, reach, moments, own, mass);
            }
        }
        Self { values, n, rows }
    }

    fn column(&self, k: usize) -> &[S] {
        &self.values[self.n + k * self.rows..][..self.rows]
    }

    fn view(&self) -> View<'_, S> {
        let (force, friction) = (&self.values[..self.n], self.column(3));
        View { kernel: self, force, bias: self.column(1), friction }
    }
}

/// Equations of which some parts are replaced.
struct View<'a, S: Number> {
    kernel: &'a Kernel<S>,
    force: &'a [S],
    bias: &'a [S],
    friction: &'a [S],
}

impl<S: Number> View<'_, S> {
    fn solved(
        &self,
        layout: &Layout,
        set: &ContactSet,
        accelerations: &mut [S],
        multipliers: &mut [S],
    ) -> bool {
        let (width, rows) = (self.kernel.n + self.kernel.rows, self.kernel.rows);
        let mut numbers = Lent::new(2 * width * width + 3 * width);
        let mut indices = Lent::new(2 * width + rows);
        Workspace::of(width, rows, &mut numbers, &mut indices)
            .is_some_and(|workspace| solve_in(workspace, self, layout, set, accelerations, multipliers))
    }
}

impl<S: Number> KernelView<S> for View<'_, S> {
    fn mass(&self, i: usize) -> &[S] {
        self.kernel.mass(i)
    }
    fn force(&self) -> &[S] {
        self.force
    }
    fn gap(&self) -> &[S] {
        self.kernel.gap()
    }
    fn jacobian(&self, i: usize) -> &[S] {
        self.kernel.jacobian(i)
    }
    fn bias(&self) -> &[S] {
        self.bias
    }
    fn drift(&self) -> &[S] {
        self.kernel.drift()
    }
    fn friction(&self) -> &[S] {
        self.friction
    }
    fn solve(
        &self,
        layout: &Layout,
        set: &ContactSet,
        accelerations: &mut [S],
        multipliers: &mut [S],
    ) -> bool {
        self.solved(layout, set, accelerations, multipliers)
    }
    fn correction(&self, layout: &Layout, set: &ContactSet, residual: &dyn Fn(usize) -> S, change: &mut [S]) {
        self.kernel.correction(layout, set, residual, change);
    }
}

impl<S: Number> KernelView<S> for Kernel<S> {
    fn mass(&self, i: usize) -> &[S] {
        &self.values[self.n + (4 + self.n) * self.rows + i * self.n..][..self.n]
    }
    fn force(&self) -> &[S] {
        &self.values[..self.n]
    }
    fn gap(&self) -> &[S] {
        self.column(0)
    }
    fn jacobian(&self, i: usize) -> &[S] {
        &self.values[self.n + 4 * self.rows + i * self.n..][..self.n]
    }
    fn bias(&self) -> &[S] {
        self.column(1)
    }
    fn drift(&self) -> &[S] {
        self.column(2)
    }
    fn friction(&self) -> &[S] {
        self.column(3)
    }
    fn solve(
        &self,
        layout: &Layout,
        set: &ContactSet,
        accelerations: &mut [S],
        multipliers: &mut [S],
    ) -> bool {
        self.view().solved(layout, set, accelerations, multipliers)
    }
    fn correction(&self, layout: &Layout, set: &ContactSet, residual: &dyn Fn(usize) -> S, change: &mut [S]) {
        let mut parts = Lent::new(self.n + 3 * self.rows);
        parts.fill(S::ZERO);
        let (zeros, rest) = parts.split_at_mut(self.n + self.rows);
        let (bias, multipliers) = rest.split_at_mut(self.rows);
        (0..self.rows).for_each(|row| bias[row] = residual(row));
        let (force, friction) = zeros.split_at(self.n);
        View { kernel: self, force, bias, friction }.solved(layout, set, change, multipliers);
    }
}
