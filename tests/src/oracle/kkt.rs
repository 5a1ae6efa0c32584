//! The dense symmetric system [M Jᵀ; J 0] [q̈; −λ] = [Q; −J̇q̇].
//!
//! It is balanced to unit rows, factorised by LU with complete pivoting and refined once; where the
//! pivots show a rank defect, the least-norm solution by singular values is taken and checked.

use nalgebra::{DMatrix, DVector};

/// Pivots (after balancing to unit rows) below this count as zero: far above rounding (1e-15 times
/// the dimension), far below what well-posed systems show.
const RANK_TOLERANCE: f64 = 1e-11;

/// Why a system has no definite accelerations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unsolvable {
    /// No accelerations meet all constraints: contradictory or jammed.
    Contradictory,
    /// A motion without inertia: the accelerations are not unique.
    Massless,
}

/// Solution of the balanced system.
pub(super) struct Solution {
    /// q̈, then −λ.
    pub(super) values: DVector<f64>,
    /// Whether the multipliers are unique.
    pub(super) unique: bool,
    /// Smallest over largest pivot.
    pub(super) pivots: f64,
}

/// Solves it. The first `free` unknowns are accelerations, which must be unique.
pub(super) fn solve(
    matrix: &DMatrix<f64>,
    right: &DVector<f64>,
    free: usize,
) -> Result<Solution, Unsolvable> {
    let scale = balance(matrix);
    let scaled = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
        scale[row] * matrix[(row, column)] * scale[column]
    });
    let target = right.component_mul(&scale);
    let lu = scaled.clone().full_piv_lu();
    let diagonal = lu.u().diagonal().abs();
    let pivots = diagonal.min() / diagonal.max();
    if pivots < RANK_TOLERANCE {
        return least_norm(matrix, right, free);
    }
    let mut values = lu.solve(&target).ok_or(Unsolvable::Massless)?;
    if let Some(correction) = lu.solve(&(&target - &scaled * &values)) {
        values += correction;
    }
    Ok(Solution { values: values.component_mul(&scale), unique: true, pivots })
}

/// Symmetric scaling that brings the largest entry of each row near one (Ruiz, three sweeps).
fn balance(matrix: &DMatrix<f64>) -> DVector<f64> {
    let mut scale = DVector::from_element(matrix.nrows(), 1.0);
    for _ in 0..3 {
        let largest = DVector::from_fn(matrix.nrows(), |row, _| {
            let entries = matrix.row(row).transpose().component_mul(&scale) * scale[row];
            entries.amax()
        });
        for (factor, size) in scale.iter_mut().zip(largest.iter()) {
            if *size > 0.0 {
                *factor /= size.sqrt();
            }
        }
    }
    scale
}

fn least_norm(matrix: &DMatrix<f64>, right: &DVector<f64>, free: usize) -> Result<Solution, Unsolvable> {
    let svd = matrix.clone().svd(true, true);
    let cut = RANK_TOLERANCE * svd.singular_values.max();
    let moves = |index: usize| {
        svd.singular_values[index] <= cut
            && svd.v_t.as_ref().is_some_and(|v| v.row(index).columns(0, free).norm() > 1e-6)
    };
    if (0..matrix.nrows()).any(moves) {
        return Err(Unsolvable::Massless);
    }
    let values = svd.solve(right, cut).map_err(|_| Unsolvable::Contradictory)?;
    let error = (right - matrix * &values).amax();
    if error > 1e-9 * (1.0 + right.amax()) {
        return Err(Unsolvable::Contradictory);
    }
    Ok(Solution { values, unique: false, pivots: 0.0 })
}
