//! Lemke's method (*Bimatrix equilibrium points and mathematical programming*, Management Science
//! 11, 1965) for the linear complementarity problem
//!
//! ```text
//! w = A z + q,    0 ≤ w ⟂ z ≥ 0
//! ```
//!
//! with the covering vector d > 0: of `w = A z + d z₀ + q` the path from large z₀ is followed until
//! z₀ = 0. The lexicographic rule excludes cycles. The path may also end in a ray, which proves
//! nothing for a matrix that is not copositive.

use crate::numerics::zero::RANK;
use nalgebra::{DMatrix, DVector};

/// Values below this part of the right-hand side's size are ties.
const TIE: f64 = 1e-13;
/// Pivots at most, for each row.
const PIVOTS: usize = 50;

/// The problem's tableau: a row for each basic variable, the columns w, z, z₀ and the values.
struct Tableau {
    size: usize,
    entries: DMatrix<f64>,
    /// The column of each row's basic variable.
    basis: Vec<usize>,
    /// Ties of the values.
    tie: f64,
}

/// Which z are basic at a solution: those that may be positive. `None` where the path ends in a
/// ray.
pub(super) fn solve(a: &DMatrix<f64>, q: &DVector<f64>, cover: &DVector<f64>) -> Option<Vec<bool>> {
    let m = q.len();
    let mut tableau = Tableau::new(a, q, cover);
    if q.iter().all(|q| *q >= -tableau.tie) {
        return Some(vec![false; m]);
    }
    let mut row = tableau.first()?;
    let mut entering = 2 * m;
    for _ in 0..PIVOTS * m.max(1) {
        let leaving = tableau.pivot(row, entering);
        if leaving == 2 * m {
            return Some((0..m).map(|k| tableau.basis.contains(&(m + k))).collect());
        }
        entering = if leaving < m { leaving + m } else { leaving - m };
        row = tableau.blocking(entering)?;
    }
    None
}

impl Tableau {
    fn new(a: &DMatrix<f64>, q: &DVector<f64>, cover: &DVector<f64>) -> Self {
        let m = q.len();
        let mut entries = DMatrix::zeros(m, 2 * m + 2);
        entries.view_mut((0, 0), (m, m)).fill_diagonal(1.0);
        entries.view_mut((0, m), (m, m)).copy_from(&-a);
        entries.set_column(2 * m, &-cover);
        entries.set_column(2 * m + 1, q);
        let tie = TIE * if m > 0 { q.amax() } else { 0.0 };
        Self { size: m, entries, basis: (0..m).collect(), tie }
    }

    /// The row that z₀ has to cover most.
    fn first(&self) -> Option<usize> {
        let rows: Vec<usize> = (0..self.size).collect();
        self.lexicographic(rows, |row| -self.entries[(row, 2 * self.size)])
    }

    /// The row whose variable vanishes first as another one grows; z₀ before others.
    fn blocking(&self, entering: usize) -> Option<usize> {
        let column = self.entries.column(entering);
        let least = RANK * column.amax();
        let rows: Vec<usize> = (0..self.size).filter(|&row| column[row] > least).collect();
        let cover = self.basis.iter().position(|&column| column == 2 * self.size);
        let row = self.lexicographic(rows.clone(), |row| column[row])?;
        let ratio = |row: usize| self.value(row) / column[row];
        match cover.filter(|cover| rows.contains(cover)) {
            Some(cover) if self.value(cover) <= self.tie || ratio(cover) <= ratio(row) => Some(cover),
            _ => Some(row),
        }
    }

    fn value(&self, row: usize) -> f64 {
        self.entries[(row, 2 * self.size + 1)]
    }

    /// The row of the lexicographically least [value, w columns] / divisor.
    fn lexicographic(&self, mut rows: Vec<usize>, divisor: impl Fn(usize) -> f64) -> Option<usize> {
        let columns = std::iter::once(2 * self.size + 1).chain(0..self.size);
        for column in columns {
            if rows.len() <= 1 {
                break;
            }
            let tie = if column > 2 * self.size { self.tie } else { TIE };
            let ratio = |row: usize| self.entries[(row, column)] / divisor(row);
            let least = rows.iter().map(|&row| ratio(row)).fold(f64::INFINITY, f64::min);
            rows.retain(|&row| ratio(row) - least <= tie / divisor(row));
        }
        rows.first().copied()
    }

    /// Exchanges the basic variable of a row for another one; returns the one that leaves.
    fn pivot(&mut self, row: usize, entering: usize) -> usize {
        let column: Vec<f64> = self.entries.column(entering).iter().copied().collect();
        for j in 0..self.entries.ncols() {
            let factor = self.entries[(row, j)] / column[row];
            if factor != 0.0 {
                let mut target = self.entries.column_mut(j);
                for (value, part) in target.iter_mut().zip(&column) {
                    *value -= part * factor;
                }
                target[row] = factor;
            }
        }
        std::mem::replace(&mut self.basis[row], entering)
    }
}
