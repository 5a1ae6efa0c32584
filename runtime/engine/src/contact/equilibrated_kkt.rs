//! `[M −Jᵀ; J 0] [a; λ] = [f; −b]` over any set of rows, by elimination with all pivots to choose
//! from; where a pivot is small, by singular value decomposition. Where redundant rows leave λ
//! undetermined, the least-norm λ is taken; an undetermined a is an error. The matrix is
//! equilibrated as in [`crate::kernel`].

use nalgebra::{DMatrix, DVector, Dyn, FullPivLU, SVD};

use super::closed_rows::{ClosedRows, levers};
use super::least_constraint::LeastConstraint;
use super::trials::LcpError;
use crate::model::Layout;
use crate::numerics::decomposition::{self, parts};
use crate::numerics::zero::{MARGIN, SOLVED};

/// The scale of a tangent is at most so many times that of its normal.
const WEAK: f64 = 1e3;

/// Steps of iterative refinement at most, as long as they lessen the residual: the decomposition
/// rounds more than the solution has to.
const REFINEMENTS: usize = 4;

/// A coordinate has a part in a motion of which its rate is this part of the largest.
const SHARE: f64 = 0.1;

/// The equations of motion with all rows, of which any may be closed.
pub(super) struct EquilibratedKkt {
    pub(super) n: usize,
    pub(super) matrix: DMatrix<f64>,
    pub(super) right: DVector<f64>,
    pub(super) scale: DVector<f64>,
    /// The part of the system that each coordinate and row belongs to: parts that no entry of the
    /// matrix connects do not act on each other.
    pub(super) parts: Vec<usize>,
    /// Rounding of each coordinate and row, from the terms of its part.
    pub(super) tolerance: DVector<f64>,
    /// The balanced size of those terms.
    pub(super) size: DVector<f64>,
    /// What says which rows are couples; where nothing does they are compared with forces as
    /// numbers.
    layout: Option<&'static Layout>,
}

/// A solution of the balanced system for one set of closed rows.
pub(super) struct TrialSolution {
    pub(super) x: DVector<f64>,
    pub(super) consistent: bool,
    pub(super) nullity: usize,
}

impl EquilibratedKkt {
    /// `size` bounds the terms that the right-hand side was summed from; it sets what counts as
    /// rounding.
    pub(super) fn new(
        mass: &DMatrix<f64>,
        jacobian: &DMatrix<f64>,
        (force, bias): (&DVector<f64>, &DVector<f64>),
        (force_size, bias_size): (&DVector<f64>, &DVector<f64>),
    ) -> Self {
        let (n, rows) = (mass.nrows(), jacobian.nrows());
        let scale = balance(mass, jacobian);
        let mut matrix = DMatrix::zeros(n + rows, n + rows);
        matrix.view_mut((0, 0), (n, n)).copy_from(mass);
        matrix.view_mut((n, 0), (rows, n)).copy_from(jacobian);
        matrix.view_mut((0, n), (n, rows)).copy_from(&-jacobian.transpose());
        let stacked = |top: &DVector<f64>, bottom: &DVector<f64>, sign: f64| {
            DVector::from_fn(n + rows, |i, _| scale[i] * if i < n { top[i] } else { sign * bottom[i - n] })
        };
        let matrix = DMatrix::from_fn(n + rows, n + rows, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
        let parts = parts(&matrix);
        let size = stacked(force_size, bias_size, 1.0);
        let tolerance = SOLVED * largest_in_part(&parts, &size);
        Self { n, matrix, right: stacked(force, bias, -1.0), parts, tolerance, scale, size, layout: None }
    }

    /// The same for the rows of a model.
    pub(super) fn with_layout(self, layout: &'static Layout) -> Self {
        Self { layout: Some(layout), ..self }
    }

    /// Limits the scale of each tangent relative to that of its normal. Where a contact cannot
    /// slip, as that of a piston at its dead centre, its tangent is zero but for rounding, and
    /// would be balanced to that of the others.
    pub(super) fn limit_tangents(&mut self, rows: impl Iterator<Item = (usize, usize)>) {
        let mut any = false;
        for (normal, tangent) in rows.map(|(normal, tangent)| (self.n + normal, self.n + tangent)) {
            let factor = WEAK * self.scale[normal] / self.scale[tangent];
            if factor < 1.0 {
                any = true;
                self.matrix.row_mut(tangent).scale_mut(factor);
                self.matrix.column_mut(tangent).scale_mut(factor);
                self.right[tangent] *= factor;
                self.size[tangent] *= factor;
                self.scale[tangent] *= factor;
            }
        }
        if any {
            self.tolerance = SOLVED * largest_in_part(&self.parts, &self.size);
        }
    }

    /// Rounding of a row's balanced opening and reaction.
    pub(super) fn slack(&self, row: usize) -> f64 {
        self.tolerance[self.n + row]
    }

    /// The same problem as one of least constraint.
    pub(super) fn least_constraint(&self) -> Result<LeastConstraint, LcpError> {
        if self.right.iter().chain(self.matrix.iter()).any(|x| !x.is_finite()) {
            return Err(LcpError::Singular);
        }
        let (n, rows) = (self.n, self.scale.len() - self.n);
        let below = |values: &DVector<f64>| values.rows(n, rows).into_owned();
        let mass = self.matrix.view((0, 0), (n, n)).into_owned();
        let jacobian = self.matrix.view((n, 0), (rows, n)).into_owned();
        let (force, bias) = (self.right.rows(0, n).into_owned(), -below(&self.right));
        LeastConstraint::new(&mass, &jacobian, (&force, &bias), &below(&self.tolerance))
    }

    /// Some rows as closed ones.
    pub(super) fn closed_rows(&self, rows: Vec<usize>) -> ClosedRows {
        let entry = |row: usize, j: usize| self.matrix[(self.n + row, j)] / self.scale[self.n + row];
        let jacobian = DMatrix::from_fn(rows.len(), self.n, |k, j| entry(rows[k], j));
        ClosedRows { levers: self.levers(&rows), rows, jacobian }
    }

    fn levers(&self, rows: &[usize]) -> Vec<f64> {
        let entry = |row: usize, j: usize| {
            self.matrix[(self.n + row, j)] / (self.scale[self.n + row] * self.scale[j])
        };
        let mass = |j: usize| self.matrix[(j, j)] / (self.scale[j] * self.scale[j]);
        self.layout.map_or_else(|| vec![1.0; rows.len()], |layout| levers(layout, rows, entry, mass))
    }

    /// Least-norm solution with the given rows closed, each part of the system for itself.
    pub(super) fn attempt(&self, rows: &[usize]) -> Result<TrialSolution, LcpError> {
        let index: Vec<usize> = (0..self.n).chain(rows.iter().map(|row| self.n + row)).collect();
        let levers = self.levers(rows);
        let mut whole = TrialSolution { x: DVector::zeros(index.len()), consistent: true, nullity: 0 };
        let parts = index.iter().map(|&i| self.parts[i]).max().map_or(0, |last| last + 1);
        for part in 0..parts {
            let places: Vec<usize> = (0..index.len()).filter(|&k| self.parts[index[k]] == part).collect();
            let own: Vec<usize> = places.iter().map(|&k| index[k]).collect();
            if own.is_empty() {
                continue;
            }
            let own_levers = places.iter().filter(|&&k| k >= self.n).map(|&k| levers[k - self.n]).collect();
            let TrialSolution { x, consistent, nullity } = self.attempt_part(&own, own_levers)?;
            places.iter().zip(x.iter()).for_each(|(&k, x)| whole.x[k] = *x);
            whole.consistent &= consistent;
            whole.nullity += nullity;
        }
        Ok(whole)
    }

    fn attempt_part(&self, index: &[usize], levers: Vec<f64>) -> Result<TrialSolution, LcpError> {
        let matrix = self.matrix.select_rows(index).select_columns(index);
        let right = self.right.select_rows(index);
        if right.iter().chain(matrix.iter()).any(|x| !x.is_finite()) {
            return Err(LcpError::Singular);
        }
        let lu = matrix.clone().full_piv_lu();
        if is_regular(&lu) {
            let (x, rest) = refined(&matrix, &right, |b| lu.solve(b))?;
            return Ok(TrialSolution { x, consistent: self.is_rounding(index, &rest), nullity: 0 });
        }
        let accelerations = index.iter().filter(|i| **i < self.n).count();
        let svd = decomposition::svd(matrix.clone());
        let cutoff = 8.0 * index.len() as f64 * f64::EPSILON * svd.singular_values.amax();
        let nullity = svd.singular_values.iter().filter(|&&s| s <= cutoff).count();
        refuse_free_accelerations(&svd, accelerations, cutoff)?;
        let (mut x, rest) = refined(&matrix, &right, |b| svd.solve(b, cutoff).ok())?;
        let consistent = self.is_rounding(index, &rest);
        if nullity > 0 {
            let mut scale = self.scale.select_rows(index);
            levers.iter().enumerate().for_each(|(k, lever)| scale[accelerations + k] /= lever);
            minimize_norm(&mut x, &svd, cutoff, (accelerations, &scale))?;
        }
        Ok(TrialSolution { x, consistent, nullity })
    }

    /// Whether what is left of these equations is rounding.
    fn is_rounding(&self, index: &[usize], rest: &DVector<f64>) -> bool {
        index.iter().zip(rest.iter()).all(|(&i, rest)| rest.abs() <= 1e3 * self.tolerance[i])
    }

    /// The accelerations that have lost half of their digits with these rows closed. Redundant rows
    /// do not count.
    pub(super) fn undetermined(&self, rows: &[usize]) -> Vec<usize> {
        let index: Vec<usize> = (0..self.n).chain(rows.iter().map(|row| self.n + row)).collect();
        let matrix = self.matrix.select_rows(&index).select_columns(&index);
        if matrix.iter().any(|x| !x.is_finite()) {
            return (0..self.n).collect();
        }
        let svd = decomposition::svd(matrix);
        let cutoff = f64::EPSILON.sqrt() * svd.singular_values.amax();
        if refuse_free_accelerations(&svd, self.n, cutoff).is_ok() {
            return Vec::new();
        }
        let weak = (0..index.len()).filter(|&k| svd.singular_values[k] <= cutoff);
        let motions: Vec<DVector<f64>> =
            svd.v_t.iter().flat_map(|v| weak.clone().map(|k| v.row(k).transpose())).collect();
        let share = |i: usize| motions.iter().map(|motion| motion[i].abs()).fold(0.0, f64::max);
        let most = (0..self.n).map(share).fold(0.0, f64::max);
        (0..self.n).filter(|&i| share(i) > SHARE * most).collect()
    }

    /// The balanced J a + b of a row.
    pub(super) fn opening(&self, row: usize, x: &DVector<f64>) -> f64 {
        let jacobian = self.matrix.row(self.n + row);
        (0..self.n).map(|j| jacobian[j] * x[j]).sum::<f64>() - self.right[self.n + row]
    }
}

/// Whether the pivots of the elimination are so near each other that no singular value can be
/// rounding: the least of them is hardly less than the least pivot.
fn is_regular(lu: &FullPivLU<f64, Dyn, Dyn>) -> bool {
    let pivots = lu.u().diagonal().abs();
    pivots.min() > MARGIN * pivots.max()
}

/// The solution by what inverts the matrix, refined, and what is left of the right-hand side.
fn refined(
    matrix: &DMatrix<f64>,
    right: &DVector<f64>,
    solve: impl Fn(&DVector<f64>) -> Option<DVector<f64>>,
) -> Result<(DVector<f64>, DVector<f64>), LcpError> {
    let mut x = solve(right).ok_or(LcpError::Singular)?;
    let mut rest = right - matrix * &x;
    for _ in 0..REFINEMENTS {
        let refined = &x + solve(&rest).ok_or(LcpError::Singular)?;
        let left = right - matrix * &refined;
        if left.amax() >= rest.amax() {
            break;
        }
        (x, rest) = (refined, left);
    }
    Ok((x, rest))
}

/// Makes the reactions, the entries behind the accelerations, the shortest in their own units,
/// couples at their levers: λ + Z c with |λ + Z c| least, Z the null space.
fn minimize_norm(
    x: &mut DVector<f64>,
    svd: &SVD<f64, Dyn, Dyn>,
    cutoff: f64,
    (accelerations, scale): (usize, &DVector<f64>),
) -> Result<(), LcpError> {
    let vectors = svd.v_t.as_ref().ok_or(LcpError::Singular)?;
    let null: Vec<usize> = (0..vectors.nrows()).filter(|&k| svd.singular_values[k] <= cutoff).collect();
    let basis = vectors.select_rows(&null).transpose();
    let rows = accelerations..x.len();
    let reactions = DVector::from_iterator(rows.len(), rows.clone().map(|i| scale[i] * x[i]));
    let entry = |i: usize, k: usize| scale[accelerations + i] * basis[(accelerations + i, k)];
    let directions = DMatrix::from_fn(rows.len(), null.len(), entry);
    let along = decomposition::svd(directions).solve(&reactions, 0.0).map_err(|_| LcpError::Singular)?;
    *x -= basis * along;
    Ok(())
}

fn refuse_free_accelerations(
    svd: &SVD<f64, Dyn, Dyn>,
    accelerations: usize,
    cutoff: f64,
) -> Result<(), LcpError> {
    let vectors = svd.v_t.as_ref().ok_or(LcpError::Singular)?;
    let free = (0..vectors.nrows())
        .filter(|&k| svd.singular_values[k] <= cutoff)
        .any(|k| vectors.row(k).columns(0, accelerations).norm() > 1e-6);
    if free { Err(LcpError::Singular) } else { Ok(()) }
}

/// Factors that make the diagonal of M one, then the largest entry of each row of J.
fn balance(mass: &DMatrix<f64>, jacobian: &DMatrix<f64>) -> DVector<f64> {
    let n = mass.nrows();
    let mut scale = DVector::from_element(n + jacobian.nrows(), 1.0);
    for j in 0..n {
        let inertia = mass[(j, j)];
        scale[j] = reciprocal(if inertia > 0.0 { inertia.sqrt() } else { jacobian.column(j).amax() });
    }
    for row in 0..jacobian.nrows() {
        let largest = (0..n).fold(0.0, |most: f64, j| most.max((jacobian[(row, j)] * scale[j]).abs()));
        scale[n + row] = reciprocal(largest);
    }
    scale
}

fn reciprocal(x: f64) -> f64 {
    if x > 0.0 { 1.0 / x } else { 1.0 }
}

/// For each entry the largest value of its part; some parts may have no entry.
pub(super) fn largest_in_part(parts: &[usize], values: &DVector<f64>) -> DVector<f64> {
    let mut largest = vec![0.0; parts.iter().max().map_or(0, |last| last + 1)];
    for (&part, &value) in parts.iter().zip(values.iter()) {
        largest[part] = f64::max(largest[part], value);
    }
    DVector::from_fn(values.len(), |i, _| largest[parts[i]])
}

#[cfg(test)]
mod tests;
