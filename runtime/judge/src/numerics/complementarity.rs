//! 0 ≤ w = W z + b ⟂ z ≥ 0 by Lemke's method with the lexicographic rule (Cottle, Pang, Stone, *The
//! Linear Complementarity Problem*, 4.4 and 4.9); for W positive semi-definite it finds a solution
//! or shows that there is none.

use crate::numerics::linear::negligible;
use crate::tape::whole;
use liftoff_core::scalar::Scalar;

/// z, basic: so many of its entries are positive as rows are independent at most; none if there is
/// no solution.
pub(crate) fn solve<S: Scalar>(matrix: &[Vec<S>], bias: &[S]) -> Option<Vec<S>> {
    let m = bias.len();
    if bias.iter().all(|&b| b >= S::ZERO) {
        return Some(vec![S::ZERO; m]);
    }
    let mut tableau = Tableau::new(matrix, bias);
    let mut entering = tableau.begin();
    // Bases are never repeated; a small problem has few.
    for _ in 0..64 * (m + 1) {
        let row = tableau.leaving(entering)?;
        let left = tableau.pivot(row, entering);
        if left == 2 * m {
            return Some(tableau.solution());
        }
        entering = (left + m) % (2 * m);
    }
    None
}

/// Columns: w, z, the artificial one, the right-hand side.
struct Tableau<S> {
    m: usize,
    rows: Vec<Vec<S>>,
    basis: Vec<usize>,
}

impl<S: Scalar> Tableau<S> {
    fn new(matrix: &[Vec<S>], bias: &[S]) -> Self {
        let m = bias.len();
        let row = |i: usize| {
            let unit = (0..m).map(|j| whole::<S>(i64::from(i == j)));
            let z = matrix[i].iter().map(|&x| -x);
            unit.chain(z).chain([-whole::<S>(1), bias[i]]).collect()
        };
        Self { m, rows: (0..m).map(row).collect(), basis: (0..m).collect() }
    }

    /// The artificial variable enters for the most negative entry; its complement follows.
    fn begin(&mut self) -> usize {
        let last = 2 * self.m + 1;
        let least = |a: &usize, b: &usize| {
            self.rows[*a][last].partial_cmp(&self.rows[*b][last]).unwrap_or(core::cmp::Ordering::Equal)
        };
        let row = (0..self.m).min_by(least).unwrap_or(0);
        let left = self.pivot(row, 2 * self.m);
        left + self.m
    }

    /// The row of the least ratio, lexicographically; none where nothing bounds what enters.
    fn leaving(&self, entering: usize) -> Option<usize> {
        let mut best: Option<usize> = None;
        let largest = self.rows.iter().map(|row| row[entering].abs().to_f64()).fold(0.0, f64::max);
        for i in 0..self.m {
            if self.rows[i][entering].to_f64() <= negligible::<S>() * largest.max(1.0) {
                continue;
            }
            best = match best {
                Some(other) if !self.precedes(i, other, entering) => Some(other),
                _ => Some(i),
            };
        }
        best
    }

    fn precedes(&self, i: usize, other: usize, entering: usize) -> bool {
        let columns = core::iter::once(2 * self.m + 1).chain(0..self.m);
        for column in columns {
            let ratio = |row: usize| self.rows[row][column] / self.rows[row][entering];
            let (a, b) = (ratio(i), ratio(other));
            let apart = (a - b).abs().to_f64();
            if apart > negligible::<S>() * a.abs().to_f64().max(b.abs().to_f64()) {
                return a < b;
            }
        }
        // The artificial variable leaves first where it can.
        self.basis[i] == 2 * self.m
    }

    /// What leaves the basis.
    fn pivot(&mut self, row: usize, entering: usize) -> usize {
        let scale = self.rows[row][entering];
        self.rows[row].iter_mut().for_each(|x| *x = *x / scale);
        let pivot = self.rows[row].clone();
        for (i, other) in self.rows.iter_mut().enumerate() {
            if i != row {
                let factor = other[entering];
                other.iter_mut().zip(&pivot).for_each(|(x, &y)| *x = *x - factor * y);
            }
        }
        core::mem::replace(&mut self.basis[row], entering)
    }

    fn solution(&self) -> Vec<S> {
        let mut z = vec![S::ZERO; self.m];
        for (i, &variable) in self.basis.iter().enumerate() {
            if (self.m..2 * self.m).contains(&variable) {
                z[variable - self.m] = self.rows[i][2 * self.m + 1];
            }
        }
        z
    }
}
