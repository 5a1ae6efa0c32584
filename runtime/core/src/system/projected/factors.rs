//! The balanced factors of K = [M −Jᵀ; J 0], for many right-hand sides.

use crate::kernel::{MatrixShape, balance, factorise};
use crate::model::KernelView;
use crate::scalar::Real;

/// P (S K S) = L U by columns, S the balance; none at first.
#[derive(Debug)]
pub(super) struct Factors {
    size: usize,
    scale: Vec<f64>,
    /// While it is factorised, by rows.
    rows: Vec<f64>,
    /// −L below the diagonal, U above, and on it the inverse of the pivot.
    columns: Vec<f64>,
    swaps: Vec<usize>,
}

impl Factors {
    pub fn of_size(size: usize) -> Self {
        let numbers = || vec![0.0; size * size];
        Self { size, scale: vec![1.0; size], rows: numbers(), columns: numbers(), swaps: vec![0; size] }
    }

    /// Factorises the equations with these rows closed; not a number where they do not determine
    /// one motion.
    pub fn factorise(&mut self, kernel: &dyn KernelView<f64>, closed: &[usize]) {
        let Self { size, scale, rows, columns, swaps } = self;
        let (size, n) = (*size, kernel.force().len());
        balance(kernel, closed, scale);
        rows.fill(0.0);
        for i in 0..n {
            for (j, entry) in kernel.mass(i).iter().enumerate() {
                rows[i * size + j] = entry * scale[i] * scale[j];
            }
        }
        for (k, &row) in (n..).zip(closed) {
            for (j, entry) in kernel.jacobian(row).iter().enumerate() {
                let entry = entry * scale[k] * scale[j];
                rows[k * size + j] = entry;
                rows[j * size + k] = -entry;
            }
        }
        let rounding = f64::EPSILON * 8.0 * size as f64;
        if !factorise(MatrixShape { size, width: size }, rows, rounding, swaps) {
            rows.fill(f64::NAN);
        }
        for (j, column) in columns.chunks_exact_mut(size.max(1)).enumerate() {
            column.iter_mut().enumerate().for_each(|(i, entry)| *entry = rows[i * size + j]);
            column[j] = 1.0 / column[j];
        }
    }

    /// K⁻¹ r in place.
    pub fn solve(&self, x: &mut [f64]) {
        let Self { size, scale, columns, swaps, .. } = self;
        x.iter_mut().zip(scale).for_each(|(x, scale)| *x *= scale);
        (0..*size).for_each(|i| x.swap(i, swaps[i]));
        let column = |j: usize| &columns[j * size..][..*size];
        for j in 0..*size {
            let (above, below) = x.split_at_mut(j + 1);
            let factor = above[j];
            below
                .iter_mut()
                .zip(&column(j)[j + 1..])
                .for_each(|(x, entry)| *x = Real::mul_add(*entry, factor, *x));
        }
        for j in (0..*size).rev() {
            let (above, below) = x.split_at_mut(j);
            let factor = below[0] * column(j)[j];
            below[0] = factor;
            above.iter_mut().zip(column(j)).for_each(|(x, entry)| *x = Real::mul_add(-*entry, factor, *x));
        }
        x.iter_mut().zip(scale).for_each(|(x, scale)| *x *= scale);
    }
}
