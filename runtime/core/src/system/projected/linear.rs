//! The series of a linear system, K₀ xₙ = rₙ − Σ Kₖ xₙ₋ₖ over 0 < k ≤ n.

use super::factors::Factors;
use crate::model::{KernelView, Varying};
use crate::series::TapeOf;

/// An entry of K = [M −Jᵀ; J 0] that varies: its row and its column, and where in the equations it
/// is found.
#[derive(Clone, Copy, Debug)]
struct VaryingEntry {
    row: usize,
    column: usize,
    source: Source,
}

#[derive(Clone, Copy, Debug)]
enum Source {
    Mass([usize; 2]),
    /// J, or −Jᵀ.
    Jacobian([usize; 2], f64),
}

/// Coefficients of K and of x = (a, λ).
#[derive(Debug)]
pub(super) struct LinearSeries {
    factors: Factors,
    /// A column of the tape each.
    entries: Vec<VaryingEntry>,
    tape: TapeOf<f64>,
    /// x₀.
    values: Vec<f64>,
    /// Of the last order.
    pub solution: Vec<f64>,
}

impl LinearSeries {
    /// With these rows closed, of equations of which those entries vary.
    pub fn new(coordinates: usize, closed: &[usize], varying: Varying<'_>) -> Self {
        let size = coordinates + closed.len();
        let mut entries = Vec::new();
        for &[i, j] in varying.mass {
            entries.push(VaryingEntry { row: i, column: j, source: Source::Mass([i, j]) });
        }
        for (k, &row) in (coordinates..).zip(closed) {
            for &[_, j] in varying.jacobian.iter().filter(|[of, _]| *of == row) {
                entries.push(VaryingEntry { row: k, column: j, source: Source::Jacobian([row, j], 1.0) });
                entries.push(VaryingEntry { row: j, column: k, source: Source::Jacobian([row, j], -1.0) });
            }
        }
        Self {
            factors: Factors::of_size(size),
            tape: TapeOf::new(entries.len()),
            entries,
            values: vec![0.0; size],
            solution: vec![0.0; size],
        }
    }

    /// Order n of the solution from that of the equations.
    pub fn next(&mut self, n: usize, kernel: &dyn KernelView<f64>, closed: &[usize]) {
        let Self { factors, entries, tape, values, solution } = self;
        let coordinates = kernel.force().len();
        solution[..coordinates].copy_from_slice(kernel.force());
        for (load, &row) in solution[coordinates..].iter_mut().zip(closed) {
            *load = -kernel.bias()[row];
        }
        if n == 0 {
            factors.factorise(kernel, closed);
            factors.solve(solution);
            return values.copy_from_slice(solution);
        }
        let order = tape.row(n);
        for ((entry, left), sum) in entries.iter().zip(&mut *order.left).zip(order.sums) {
            let coefficient = match entry.source {
                Source::Mass([i, j]) => kernel.mass(i)[j],
                Source::Jacobian([row, j], sign) => sign * kernel.jacobian(row)[j],
            };
            *left = coefficient;
            solution[entry.row] -= coefficient * values[entry.column] + sum;
        }
        factors.solve(solution);
        for (entry, right) in entries.iter().zip(order.right) {
            *right = solution[entry.column];
        }
    }
}
