//! 0 ≤ J a + b ⟂ λ ≥ 0 over the candidate rows, J a + b = 0 over the fixed ones, with M a = f + Jᵀ λ.
//!
//! Murty's least-index principal pivoting finds the set of a regular problem; where supports are redundant and it
//! fails, all sets are tried. Of several λ ≥ 0 with the same accelerations the one of least norm is taken.

use nalgebra::{DMatrix, DVector, Dyn, SVD};

/// Up to this many candidates all sets may be tried.
const EXHAUSTIVE: usize = 14;

/// Rounding allowed in reactions and openings of the balanced problem, relative to its right-hand side: some ten
/// digits of conditioning above the unit roundoff would be lost before a sign is in doubt.
const ROUNDING: f64 = 1e-12;

/// One linear complementarity problem, balanced as [`crate::kernel`] does it.
pub(crate) struct Problem {
    n: usize,
    matrix: DMatrix<f64>,
    right: DVector<f64>,
    scale: DVector<f64>,
    tolerance: f64,
}

/// Accelerations with their reactions and openings.
#[derive(Debug, Clone)]
pub(crate) struct Solution {
    pub(crate) accelerations: DVector<f64>,
    /// λ of every row, zero where it is not closed.
    pub(crate) reactions: DVector<f64>,
    /// Candidates with neither a reaction nor an opening.
    pub(crate) degenerate: Vec<usize>,
    /// Candidates that bear.
    pub(crate) bearing: Vec<usize>,
    /// Whether λ is the only one.
    pub(crate) unique: bool,
}

/// Why there is no solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Failure {
    Jammed,
    Singular,
}

/// A solution of the balanced system for one set of closed rows.
struct Attempt {
    x: DVector<f64>,
    consistent: bool,
    nullity: usize,
}

impl Problem {
    /// `size` bounds the terms that the right-hand side was summed from; it sets what counts as rounding.
    pub(crate) fn new(
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

    /// The solution, its set found among the `candidates` beside the `fixed` rows.
    pub(crate) fn solve(&self, fixed: &[usize], candidates: &[usize]) -> Result<Solution, Failure> {
        let (closed, attempt) = match self.pivot(fixed, candidates) {
            Some(found) => found,
            None => self.exhaust(fixed, candidates)?,
        };
        Ok(self.finish(fixed, candidates, &closed, attempt))
    }

    /// Murty: from all closed, flip the least violated index until none is.
    fn pivot(&self, fixed: &[usize], candidates: &[usize]) -> Option<(Vec<usize>, Attempt)> {
        let mut closed = vec![true; candidates.len()];
        for _ in 0..1usize << candidates.len().min(EXHAUSTIVE) {
            let rows = chosen(fixed, candidates, &closed);
            let attempt = self.attempt(&rows).ok()?;
            let violated = (0..candidates.len()).find(|&k| !self.holds(candidates[k], closed[k], &rows, &attempt));
            match violated {
                Some(k) => closed[k] = !closed[k],
                None if attempt.consistent => return Some((rows, attempt)),
                None => return None,
            }
        }
        None
    }

    /// Every set, the larger first.
    fn exhaust(&self, fixed: &[usize], candidates: &[usize]) -> Result<(Vec<usize>, Attempt), Failure> {
        let count = candidates.len().min(EXHAUSTIVE);
        let mut sets: Vec<u32> = (0..1u32 << count).collect();
        sets.sort_by_key(|set| (count as u32 - set.count_ones(), *set));
        let mut failure = Failure::Jammed;
        for set in sets {
            let closed: Vec<bool> = (0..candidates.len()).map(|k| k >= count || set >> k & 1 == 1).collect();
            let rows = chosen(fixed, candidates, &closed);
            match self.attempt(&rows) {
                Ok(attempt)
                    if attempt.consistent
                        && (0..closed.len()).all(|k| self.holds(candidates[k], closed[k], &rows, &attempt)) =>
                {
                    return Ok((rows, attempt));
                }
                Ok(_) => {}
                Err(singular) => failure = singular,
            }
        }
        Err(failure)
    }

    /// Least-norm solution with the given rows closed.
    fn attempt(&self, rows: &[usize]) -> Result<Attempt, Failure> {
        let index: Vec<usize> = (0..self.n).chain(rows.iter().map(|row| self.n + row)).collect();
        let matrix = self.matrix.select_rows(&index).select_columns(&index);
        let right = self.right.select_rows(&index);
        if right.iter().chain(matrix.iter()).any(|x| !x.is_finite()) {
            return Err(Failure::Singular);
        }
        let svd = matrix.clone().svd(true, true);
        let cutoff = 8.0 * index.len() as f64 * f64::EPSILON * svd.singular_values.amax();
        let nullity = svd.singular_values.iter().filter(|&&s| s <= cutoff).count();
        self.refuse_free_accelerations(&svd, cutoff)?;
        let solve = |b: &DVector<f64>| svd.solve(b, cutoff).map_err(|_| Failure::Singular);
        let mut x = solve(&right)?;
        x += solve(&(&right - &matrix * &x))?;
        let consistent = (&right - &matrix * &x).amax() <= 1e3 * self.tolerance;
        if nullity > 0 {
            let scale = self.scale.select_rows(&index);
            self.shorten(&mut x, &svd, cutoff, &scale)?;
        }
        Ok(Attempt { x, consistent, nullity })
    }

    /// Makes the reactions the shortest in their own units: λ + Z c with |λ + Z c| least, Z the null space.
    fn shorten(
        &self,
        x: &mut DVector<f64>,
        svd: &SVD<f64, Dyn, Dyn>,
        cutoff: f64,
        scale: &DVector<f64>,
    ) -> Result<(), Failure> {
        let vectors = svd.v_t.as_ref().ok_or(Failure::Singular)?;
        let null: Vec<usize> = (0..vectors.nrows()).filter(|&k| svd.singular_values[k] <= cutoff).collect();
        let basis = vectors.select_rows(&null).transpose();
        let rows = self.n..x.len();
        let reactions = DVector::from_iterator(rows.len(), rows.clone().map(|i| scale[i] * x[i]));
        let directions = DMatrix::from_fn(rows.len(), null.len(), |i, k| scale[self.n + i] * basis[(self.n + i, k)]);
        let along = directions.svd(true, true).solve(&reactions, 0.0).map_err(|_| Failure::Singular)?;
        *x -= basis * along;
        Ok(())
    }

    fn refuse_free_accelerations(
        &self,
        svd: &SVD<f64, Dyn, Dyn>,
        cutoff: f64,
    ) -> Result<(), Failure> {
        let vectors = svd.v_t.as_ref().ok_or(Failure::Singular)?;
        let free = (0..vectors.nrows())
            .filter(|&k| svd.singular_values[k] <= cutoff)
            .any(|k| vectors.row(k).columns(0, self.n).norm() > 1e-6);
        if free { Err(Failure::Singular) } else { Ok(()) }
    }

    /// Whether a candidate's condition is met: λ ≥ 0 if closed, J a + b ≥ 0 if open.
    fn holds(&self, row: usize, closed: bool, rows: &[usize], attempt: &Attempt) -> bool {
        if closed {
            let reaction = rows.iter().position(|&r| r == row).map_or(0.0, |k| attempt.x[self.n + k]);
            reaction >= -self.tolerance
        } else {
            self.opening(row, &attempt.x) >= -self.tolerance
        }
    }

    /// The balanced J a + b of a row.
    fn opening(&self, row: usize, x: &DVector<f64>) -> f64 {
        let slope = self.matrix.row(self.n + row);
        (0..self.n).map(|j| slope[j] * x[j]).sum::<f64>() - self.right[self.n + row]
    }

    fn finish(&self, fixed: &[usize], candidates: &[usize], rows: &[usize], attempt: Attempt) -> Solution {
        let tight: Vec<usize> = candidates
            .iter()
            .copied()
            .filter(|row| rows.contains(row) || self.opening(*row, &attempt.x).abs() <= self.tolerance)
            .collect();
        let all = chosen(fixed, &tight, &vec![true; tight.len()]);
        let unique = self.attempt(&all).map_or(attempt.nullity == 0, |full| full.nullity == 0);
        let (rows, x) = if unique { (rows.to_vec(), attempt.x) } else { self.least_norm(fixed, &tight, rows, attempt) };
        let mut balanced = DVector::zeros(self.scale.len() - self.n);
        for (k, &row) in rows.iter().enumerate() {
            balanced[row] = x[self.n + k];
        }
        let bears = |row: &usize| balanced[*row] > self.tolerance;
        Solution {
            accelerations: DVector::from_fn(self.n, |i, _| x[i] * self.scale[i]),
            bearing: tight.iter().copied().filter(bears).collect(),
            degenerate: tight.iter().copied().filter(|row| !bears(row)).collect(),
            reactions: DVector::from_fn(balanced.len(), |row, _| balanced[row] * self.scale[self.n + row]),
            unique,
        }
    }

    /// Of all λ ≥ 0 on the tight rows the shortest; on its support it is the shortest without the sign condition.
    fn least_norm(
        &self,
        fixed: &[usize],
        tight: &[usize],
        rows: &[usize],
        attempt: Attempt,
    ) -> (Vec<usize>, DVector<f64>) {
        let length = |rows: &[usize], x: &DVector<f64>| {
            (0..rows.len()).map(|k| (x[self.n + k] * self.scale[self.n + rows[k]]).powi(2)).sum::<f64>()
        };
        let mut best = (rows.to_vec(), attempt.x);
        let count = tight.len().min(EXHAUSTIVE);
        for set in 0..1u32 << count {
            let closed: Vec<bool> = (0..tight.len()).map(|k| k < count && set >> k & 1 == 1).collect();
            let rows = chosen(fixed, tight, &closed);
            if let Ok(attempt) = self.attempt(&rows)
                && attempt.consistent
                && tight.iter().zip(&closed).all(|(&row, &closed)| self.holds(row, closed, &rows, &attempt))
                && length(&rows, &attempt.x) < length(&best.0, &best.1)
            {
                best = (rows, attempt.x);
            }
        }
        best
    }
}

fn chosen(fixed: &[usize], candidates: &[usize], closed: &[bool]) -> Vec<usize> {
    let kept = candidates.iter().zip(closed).filter(|(_, closed)| **closed).map(|(row, _)| *row);
    let mut rows: Vec<usize> = fixed.iter().copied().chain(kept).collect();
    rows.sort_unstable();
    rows
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
