//! The full equations at a state.

use liftoff_core::kernel::{Workspace, correct_in, solve_in, write_mass};
use liftoff_core::model::{ContactSet, KernelView, Layout};

use super::full::{FullCode, MassForm};
use crate::pool::{Lent, Number};

/// What code has computed of the equations: f, g, b, ∂g/∂t, σμ, J, M.
pub(crate) struct Kernel<S: Number> {
    values: Lent<S>,
    n: usize,
    rows: usize,
}

impl<S: Number> Kernel<S> {
    pub fn evaluate(code: &FullCode, constants: &[S], state: &[S]) -> Self {
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

    /// Of what has been computed, M entry by entry.
    pub fn from_values(code: &FullCode, values: Lent<S>) -> Self {
        Self { values, n: code.coordinates, rows: code.rows }
    }

    fn column(&self, k: usize) -> &[S] {
        &self.values[self.n + k * self.rows..][..self.rows]
    }

    /// What `solve` makes of memory for these equations with the rows of a set closed.
    fn lent<R>(
        &self,
        layout: &Layout,
        set: &ContactSet,
        solve: impl FnOnce(Workspace<'_, S>) -> R,
    ) -> Option<R> {
        let closed = (0..self.rows).filter(|&row| layout.is_closed(row, set)).count();
        let (width, rows) = (self.n + closed, self.rows);
        let mut numbers = Lent::new(2 * width * width + 3 * width);
        let mut indices = Lent::new(2 * width + rows);
        Workspace::split(width, rows, &mut numbers, &mut indices).map(solve)
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
    fn prescribed_gap_rate(&self) -> &[S] {
        self.column(2)
    }
    fn friction(&self) -> &[S] {
        self.column(3)
    }
    fn push(&mut self, row: usize, multiplier: S) {
        for j in 0..self.n {
            let entry = self.jacobian(row)[j];
            self.values[j] = entry.mul_add(multiplier, self.values[j]);
        }
    }
    fn solve(
        &self,
        layout: &Layout,
        set: &ContactSet,
        accelerations: &mut [S],
        multipliers: &mut [S],
    ) -> bool {
        let solved =
            self.lent(layout, set, |memory| solve_in(memory, self, layout, set, accelerations, multipliers));
        solved.unwrap_or(false)
    }
    fn correction(&self, layout: &Layout, set: &ContactSet, residual: &dyn Fn(usize) -> S, change: &mut [S]) {
        self.lent(layout, set, |memory| correct_in(memory, self, layout, set, residual, change));
    }
}
