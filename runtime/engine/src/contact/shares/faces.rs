//! The shortest reactions by the faces of their cones on which they lie: K is bounded by planes,
//! and `½ |λ|² → min` with Jᵀ λ = F is a problem of least constraint in which λ stands for the
//! accelerations. It comes to an end where Newton's method does not: on a face that moves the
//! system less than its load asks for, the derivative of Jᵀ λ(y) is singular.

use nalgebra::{DMatrix, DVector, RowDVector};

use super::{Factor, Shares};
use crate::contact::least_constraint::LeastConstraint;
use crate::numerics::decomposition::{singular_values, svd};
use crate::numerics::zero::{SOLVED, roundoff};

/// Rounding of F beside its terms.
const ROUNDING: f64 = roundoff(16.0);
/// A singular value below this part of the largest is zero.
const ZERO: f64 = roundoff(64.0);

/// Jᵀ λ = F and the planes of K, one a row.
struct Conditions {
    rows: DMatrix<f64>,
    right: DVector<f64>,
    /// Those that hold as equations, Jᵀ λ = F first.
    held: Vec<usize>,
    /// Those that λ stays above.
    above: Vec<usize>,
}

impl Shares {
    /// λ and y; `None` where rounding puts F beyond what K bears.
    pub(super) fn shortest_on_faces(&self) -> Option<(DVector<f64>, DVector<f64>)> {
        let it = self.conditions();
        let closed = it.closed()?;
        let reactions = it.solve(&closed)?;
        let y = least_squares(&it.rows.select_rows(&closed).transpose(), &reactions)?;
        let y = y.rows(0, self.load.len()).into_owned();
        // λ(y) is on its faces without rounding.
        self.shortest_from(y.clone()).or_else(|| it.are_met(&reactions).then_some((reactions, y)))
    }

    fn conditions(&self) -> Conditions {
        let [held, above] = self.planes();
        let motions = self.jacobian.column_iter().map(|column| column.transpose());
        let held: Vec<RowDVector<f64>> = motions.chain(held).collect();
        let (first, count) = (held.len(), held.len() + above.len());
        Conditions {
            rows: DMatrix::from_rows(&[held, above].concat()),
            right: self.load.clone().resize_vertically(count, 0.0),
            held: (0..first).collect(),
            above: (first..count).collect(),
        }
    }

    /// Planes through the apex, with normals of unit length: those that hold λ, and those that it
    /// stays above.
    fn planes(&self) -> [Vec<RowDVector<f64>>; 2] {
        let plane = |entries: &[(usize, f64)]| {
            let mut plane = RowDVector::zeros(self.jacobian.nrows());
            entries.iter().for_each(|&(k, x)| plane[k] = x);
            plane.normalize()
        };
        let (mut held, mut above) = (Vec::new(), Vec::new());
        for factor in &self.factors {
            match *factor {
                Factor::Pressing(normal) => above.push(plane(&[(normal, 1.0)])),
                Factor::Edge { normal, tangent, slope } => {
                    held.push(plane(&[(normal, -slope), (tangent, 1.0)]));
                    above.push(plane(&[(normal, 1.0)]));
                }
                Factor::Cone { normal, tangent, limit } => {
                    above.extend([1.0, -1.0].map(|sign| plane(&[(normal, limit), (tangent, sign)])));
                    // Without friction the others leave the sign of λ_N open.
                    above.push(plane(&[(normal, 1.0)]));
                }
            }
        }
        [held, above]
    }
}

impl Conditions {
    /// Those that hold the shortest λ, the faces it is on among them.
    fn closed(&self) -> Option<Vec<usize>> {
        let slack = known(&self.rows.select_rows(&self.held)).max(SOLVED) * self.solve(&self.held)?.norm();
        let bearing = self.least_constraint(slack)?.find_active_basis(&self.held, &self.above).ok()?;
        let mut closed = self.held.clone();
        closed.extend(bearing.into_iter().filter(|row| self.above.contains(row)));
        // What is beyond a face but for rounding is on it.
        let beyond = &self.rows * self.solve(&closed)?;
        let others: Vec<usize> = self.above.iter().copied().filter(|row| !closed.contains(row)).collect();
        closed.extend(others.into_iter().filter(|&row| beyond[row] < 0.0));
        Some(closed)
    }

    fn least_constraint(&self, slack: f64) -> Option<LeastConstraint> {
        let (count, size) = self.rows.shape();
        let (unit, free) = (DMatrix::identity(size, size), DVector::zeros(size));
        let slack = DVector::repeat(count, slack);
        LeastConstraint::new(&unit, &self.rows, (&free, &-&self.right), &slack).ok()
    }

    /// The shortest λ with some of the conditions as equations.
    fn solve(&self, closed: &[usize]) -> Option<DVector<f64>> {
        least_squares(&self.rows.select_rows(closed), &self.right.select_rows(closed))
    }

    fn are_met(&self, reactions: &DVector<f64>) -> bool {
        let rest = &self.rows * reactions - &self.right;
        let (most, size) = (SOLVED * self.right.norm(), SOLVED * reactions.norm());
        let is_held =
            self.held.iter().all(|&row| rest[row].abs() <= most.max(size * self.rows.row(row).norm()));
        is_held && self.above.iter().all(|&row| rest[row] >= -size)
    }
}

/// How well reactions are known that follow from a load: its rounding by the condition number.
fn known(rows: &DMatrix<f64>) -> f64 {
    let lengths = rows.row_iter().map(|row| if row.norm() > 0.0 { 1.0 / row.norm() } else { 0.0 });
    let units = DVector::from_iterator(rows.nrows(), lengths);
    let values = singular_values(DMatrix::from_diagonal(&units) * rows);
    let largest = values[0];
    let kept = values.iter().filter(|value| **value > ZERO * largest);
    ROUNDING * kept.fold(1.0, |most: f64, value| most.max(largest / value))
}

/// The shortest solution, once refined.
fn least_squares(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let svd = svd(matrix.clone());
    let cutoff = ZERO * svd.singular_values.amax();
    let x = svd.solve(right, cutoff).ok()?;
    let rest = right - matrix * &x;
    Some(x + svd.solve(&rest, cutoff).ok()?)
}

#[cfg(test)]
mod tests;
