//! Solutions with derivatives by the factors of the values K₀ alone:
//!
//! ```text
//! K₀ x₀ = r₀,    K₀ δ = r − K x₀,    x = x₀ + δ
//! ```
//!
//! What is missing is (K − K₀) δ, a product of derivatives, which is nothing. So there is one
//! elimination of plain numbers, where one of numbers with derivatives costs as much again for each
//! of them.

use crate::scalar::{Real, Scalar};

/// So many rows and columns, the rows `width` apart.
#[derive(Clone, Copy)]
pub(crate) struct MatrixShape {
    pub(crate) size: usize,
    pub(crate) width: usize,
}

/// Writes the solution and takes the right-hand side for it, where every column has a pivot above
/// `rounding`; whether it has. `factors` and `swaps` are memory.
pub(super) fn refined<S: Scalar>(
    shape: MatrixShape,
    matrix: &[S],
    right: &mut [S],
    rounding: f64,
    (factors, swaps): (&mut [S], &mut [usize]),
    solution: &mut [S],
) -> bool {
    for (factor, entry) in factors.iter_mut().zip(matrix) {
        *factor = S::from_f64(entry.to_f64());
    }
    if !factorise(shape, factors, rounding, swaps) {
        return false;
    }
    for (x, entry) in solution.iter_mut().zip(right.iter()) {
        *x = S::from_f64(entry.to_f64());
    }
    substitute(shape, factors, swaps, solution);
    for (i, entry) in right[..shape.size].iter_mut().enumerate() {
        let row = matrix[i * shape.width..].iter().zip(&solution[..shape.size]);
        *entry = row.fold(*entry, |left, (k, x)| left - k.scaled(x.to_f64()));
    }
    substitute(shape, factors, swaps, right);
    solution.iter_mut().zip(right).for_each(|(x, change)| *x = *x + *change);
    true
}

/// P K₀ = L U in place, with partial pivoting; whether each pivot is above `rounding`.
pub(crate) fn factorise<S: Scalar>(
    shape: MatrixShape,
    factors: &mut [S],
    rounding: f64,
    swaps: &mut [usize],
) -> bool {
    let MatrixShape { size, width } = shape;
    for column in 0..size {
        let weight = |row: usize| factors[row * width + column].to_f64().abs();
        let pivot =
            (column..size).fold(column, |best, row| if weight(row) > weight(best) { row } else { best });
        // Not a number is not above it.
        let is_regular = weight(pivot) > rounding;
        if !is_regular {
            return false;
        }
        swaps[column] = pivot;
        (0..size)
            .filter(|_| pivot != column)
            .for_each(|j| factors.swap(column * width + j, pivot * width + j));
        let (above, below) = factors.split_at_mut((column + 1) * width);
        let above = &above[column * width..];
        for entries in below.chunks_exact_mut(width).take(size - column - 1) {
            let factor = -entries[column].to_f64() / above[column].to_f64();
            entries[column] = S::from_f64(factor);
            for j in column + 1..size {
                entries[j] = S::from_f64(Real::mul_add(above[j].to_f64(), factor, entries[j].to_f64()));
            }
        }
    }
    true
}

/// U⁻¹ L⁻¹ P x in place.
fn substitute<S: Scalar>(shape: MatrixShape, factors: &[S], swaps: &[usize], x: &mut [S]) {
    let size = shape.size;
    let at = |i: usize, j: usize| factors[i * shape.width + j].to_f64();
    (0..size).for_each(|i| x.swap(i, swaps[i]));
    for i in 0..size {
        x[i] = (0..i).fold(x[i], |sum, j| sum + x[j].scaled(at(i, j)));
    }
    for i in (0..size).rev() {
        let left = (i + 1..size).fold(x[i], |sum, j| sum - x[j].scaled(at(i, j)));
        x[i] = left.scaled(1.0 / at(i, i));
    }
}

#[cfg(test)]
mod tests;
