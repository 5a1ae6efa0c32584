//! Dense systems by elimination with full pivoting; equations that depend on others are left out,
//! and what they lack is told.

use liftoff_core::scalar::{Real, Scalar};

/// What is rounding, relative to what it was computed from: 1e-20 of a double-double, 1e-10 of a
/// double.
pub(crate) fn negligible<S: Scalar>() -> f64 {
    S::EPSILON.to_f64().powf(0.65)
}

/// A factorised square matrix.
#[derive(Clone, Debug)]
pub(crate) struct Factors<S> {
    entries: Vec<Vec<S>>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    rank: usize,
    row_scales: Vec<S>,
    column_scales: Vec<S>,
}

const PASSES: usize = 4;
/// Constraints that differ by this, relative to their entries, differ by the rounding of what was
/// given in doubles.
const GIVEN: f64 = 2.0 * f64::EPSILON;

impl<S: Scalar> Factors<S> {
    /// Factorises a matrix by rows: `unknowns` equations with a mass matrix, then constraints on
    /// these unknowns alone. Pivots are taken from the constraints first: where these all but
    /// depend on each other, by δ, what follows is known to ε/δ, with pivots of the mass matrix to
    /// ε/δ².
    pub fn factorise(mut entries: Vec<Vec<S>>, unknowns: usize) -> Self {
        let n = entries.len();
        let (row_scales, column_scales) = equilibrate(&mut entries);
        let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = ((0..n).collect(), (0..n).collect());
        let (mut rank, mut constrains) = (n, true);
        for k in 0..n {
            let is_constraint = |i: usize, j: usize| rows[i] >= unknowns && columns[j] < unknowns;
            let constraint = constrains.then(|| pivot(&entries, k, is_constraint));
            let constraint = constraint.filter(|(.., largest)| *largest > negligible::<S>().max(GIVEN));
            constrains = constraint.is_some();
            let (i, j, largest) = constraint.unwrap_or_else(|| pivot(&entries, k, |i, _| rows[i] < unknowns));
            if largest.is_nan() || largest <= negligible::<S>() {
                rank = k;
                break;
            }
            entries.swap(k, i);
            rows.swap(k, i);
            entries.iter_mut().for_each(|row| row.swap(k, j));
            columns.swap(k, j);
            let (above, below) = entries.split_at_mut(k + 1);
            let top = &above[k];
            for row in below {
                if row[k] == S::ZERO {
                    continue;
                }
                let factor = row[k] / top[k];
                row[k] = factor;
                for (x, &y) in row[k + 1..].iter_mut().zip(&top[k + 1..]) {
                    if y != S::ZERO {
                        *x = *x - factor * y;
                    }
                }
            }
        }
        Self { entries, rows, columns, rank, row_scales, column_scales }
    }

    /// The least pivot beside the largest.
    pub fn firmness(&self) -> f64 {
        let pivots = (0..self.rank).map(|k| self.entries[k][k].abs().to_f64());
        let (least, largest) =
            pivots.fold((f64::INFINITY, 0.0_f64), |(least, largest), p| (least.min(p), largest.max(p)));
        least / largest
    }

    /// A solution, zero where it is not determined; the largest contradiction, and the size of the
    /// right-hand side.
    pub fn solve(&self, right: &[S]) -> (Vec<S>, f64, f64) {
        let n = self.rows.len();
        let mut y: Vec<S> = self.rows.iter().map(|&i| right[i] * self.row_scales[i]).collect();
        let size = y.iter().map(|x| x.abs().to_f64()).fold(0.0, f64::max);
        for k in 0..self.rank {
            for i in k + 1..n {
                y[i] = y[i] - self.entries[i][k] * y[k];
            }
        }
        let left = y[self.rank..].iter().map(|x| x.abs().to_f64()).fold(0.0, f64::max);
        for k in (0..self.rank).rev() {
            let known = (k + 1..self.rank).fold(y[k], |sum, j| sum - self.entries[k][j] * y[j]);
            y[k] = known / self.entries[k][k];
        }
        let mut x = vec![S::ZERO; n];
        for k in 0..self.rank {
            x[self.columns[k]] = y[k] * self.column_scales[self.columns[k]];
        }
        (x, left, size)
    }
}

/// The largest entry from row and column k on among those that may be one.
fn pivot<S: Scalar>(
    entries: &[Vec<S>],
    k: usize,
    may_be: impl Fn(usize, usize) -> bool,
) -> (usize, usize, f64) {
    let mut best = (k, k, 0.0);
    for (i, row) in entries.iter().enumerate().skip(k) {
        for (j, x) in row.iter().enumerate().skip(k) {
            let size = x.abs().to_f64();
            if may_be(i, j) && (size > best.2 || size.is_nan()) {
                best = (i, j, size);
            }
        }
    }
    best
}

/// Rows and columns scaled by powers of two to largest entries near 1.
fn equilibrate<S: Scalar>(entries: &mut [Vec<S>]) -> (Vec<S>, Vec<S>) {
    let n = entries.len();
    let (mut rows, mut columns) = (vec![1.0; n], vec![1.0; n]);
    let size = |x: S| x.abs().to_f64();
    for _ in 0..PASSES {
        for i in 0..n {
            let largest = (0..n).map(|j| size(entries[i][j]) * rows[i] * columns[j]).fold(0.0, f64::max);
            rows[i] *= root_of_two(largest);
        }
        for j in 0..n {
            let largest = (0..n).map(|i| size(entries[i][j]) * rows[i] * columns[j]).fold(0.0, f64::max);
            columns[j] *= root_of_two(largest);
        }
    }
    let scalars = |all: Vec<f64>| all.into_iter().map(<S as Real>::from_f64).collect::<Vec<S>>();
    let (rows, columns) = (scalars(rows), scalars(columns));
    for (row, &scale) in entries.iter_mut().zip(&rows) {
        row.iter_mut().zip(&columns).for_each(|(x, &other)| *x = *x * scale * other);
    }
    (rows, columns)
}

/// A power of two near 1/√x.
fn root_of_two(x: f64) -> f64 {
    if x > 0.0 && x.is_finite() { (-0.5 * x.log2()).round().exp2() } else { 1.0 }
}
