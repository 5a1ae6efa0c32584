//! `[M −Jᵀ; J 0] [a; λ] = [f; −b]` over any set of rows, by singular value decomposition. Where redundant rows leave λ
//! undetermined, the least-norm λ is taken; an undetermined a is an error. The matrix is equilibrated as in [`crate::kernel`].

use nalgebra::{DMatrix, DVector, Dyn, SVD};

use super::complementarity::LcpError;

/// Rounding allowed in reactions and openings of the balanced problem, relative to its right-hand side: the unit
/// roundoff and a condition number of some thousands.
const ROUNDING: f64 = 1e-12;

/// Steps of iterative refinement at most: nalgebra's singular value decomposition has been seen to leave an error of
/// 4e-4 in a matrix of condition 13, of which each step takes some six digits.
const REFINEMENTS: usize = 4;

/// The equations of motion with all rows, of which any may be closed.
pub(super) struct EquilibratedKkt {
    pub(super) n: usize,
    matrix: DMatrix<f64>,
    right: DVector<f64>,
    pub(super) scale: DVector<f64>,
    pub(super) tolerance: f64,
}

/// A solution of the balanced system for one set of closed rows.
pub(super) struct TrialSolution {
    pub(super) x: DVector<f64>,
    pub(super) consistent: bool,
    pub(super) nullity: usize,
}

impl EquilibratedKkt {
    /// `size` bounds the terms that the right-hand side was summed from; it sets what counts as rounding.
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
        Self {
            n,
            matrix: DMatrix::from_fn(n + rows, n + rows, |i, j| matrix[(i, j)] * scale[i] * scale[j]),
            right: stacked(force, bias, -1.0),
            tolerance: ROUNDING * stacked(force_size, bias_size, 1.0).amax(),
            scale,
        }
    }

    /// Least-norm solution with the given rows closed.
    pub(super) fn attempt(&self, rows: &[usize]) -> Result<TrialSolution, LcpError> {
        let index: Vec<usize> = (0..self.n).chain(rows.iter().map(|row| self.n + row)).collect();
        let matrix = self.matrix.select_rows(&index).select_columns(&index);
        let right = self.right.select_rows(&index);
        if right.iter().chain(matrix.iter()).any(|x| !x.is_finite()) {
            return Err(LcpError::Singular);
        }
        let svd = matrix.clone().svd(true, true);
        let cutoff = 8.0 * index.len() as f64 * f64::EPSILON * svd.singular_values.amax();
        let nullity = svd.singular_values.iter().filter(|&&s| s <= cutoff).count();
        self.refuse_free_accelerations(&svd, cutoff)?;
        let solve = |b: &DVector<f64>| svd.solve(b, cutoff).map_err(|_| LcpError::Singular);
        let mut x = solve(&right)?;
        let mut rest = &right - &matrix * &x;
        for _ in 0..REFINEMENTS {
            let refined = &x + solve(&rest)?;
            let left = &right - &matrix * &refined;
            if left.amax() >= rest.amax() {
                break;
            }
            (x, rest) = (refined, left);
        }
        let consistent = rest.amax() <= 1e3 * self.tolerance;
        if nullity > 0 {
            let scale = self.scale.select_rows(&index);
            self.minimize_norm(&mut x, &svd, cutoff, &scale)?;
        }
        Ok(TrialSolution { x, consistent, nullity })
    }

    /// Whether the accelerations with these rows closed have lost half of their digits. Redundant rows do not count.
    pub(super) fn is_singular(&self, rows: &[usize]) -> bool {
        let index: Vec<usize> = (0..self.n).chain(rows.iter().map(|row| self.n + row)).collect();
        let matrix = self.matrix.select_rows(&index).select_columns(&index);
        if matrix.iter().any(|x| !x.is_finite()) {
            return true;
        }
        let svd = matrix.svd(false, true);
        self.refuse_free_accelerations(&svd, f64::EPSILON.sqrt() * svd.singular_values.amax()).is_err()
    }

    /// Makes the reactions the shortest in their own units: λ + Z c with |λ + Z c| least, Z the null space.
    fn minimize_norm(
        &self,
        x: &mut DVector<f64>,
        svd: &SVD<f64, Dyn, Dyn>,
        cutoff: f64,
        scale: &DVector<f64>,
    ) -> Result<(), LcpError> {
        let vectors = svd.v_t.as_ref().ok_or(LcpError::Singular)?;
        let null: Vec<usize> = (0..vectors.nrows()).filter(|&k| svd.singular_values[k] <= cutoff).collect();
        let basis = vectors.select_rows(&null).transpose();
        let rows = self.n..x.len();
        let reactions = DVector::from_iterator(rows.len(), rows.clone().map(|i| scale[i] * x[i]));
        let directions =
            DMatrix::from_fn(rows.len(), null.len(), |i, k| scale[self.n + i] * basis[(self.n + i, k)]);
        let along = directions.svd(true, true).solve(&reactions, 0.0).map_err(|_| LcpError::Singular)?;
        *x -= basis * along;
        Ok(())
    }

    fn refuse_free_accelerations(&self, svd: &SVD<f64, Dyn, Dyn>, cutoff: f64) -> Result<(), LcpError> {
        let vectors = svd.v_t.as_ref().ok_or(LcpError::Singular)?;
        let free = (0..vectors.nrows())
            .filter(|&k| svd.singular_values[k] <= cutoff)
            .any(|k| vectors.row(k).columns(0, self.n).norm() > 1e-6);
        if free { Err(LcpError::Singular) } else { Ok(()) }
    }

    /// The balanced J a + b of a row.
    pub(super) fn opening(&self, row: usize, x: &DVector<f64>) -> f64 {
        let jacobian = self.matrix.row(self.n + row);
        (0..self.n).map(|j| jacobian[j] * x[j]).sum::<f64>() - self.right[self.n + row]
    }
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
