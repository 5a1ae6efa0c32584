//! The least value of a linear function between linear bounds,
//!
//! ```text
//! g·x → min,    s = A x − b ≥ 0
//! ```
//!
//! by the simplex method on dictionaries, in which some variables and the value are sums of the
//! others (Chvátal, *Linear Programming*, 1983, chapters 2 and 3). The x, which have no sign, are
//! exchanged for slacks s first; then the shortfall s₀ of `s + s₀ ≥ 0`, for the slacks that are
//! left, is made least, and then g·x. Bland's rule, of the first variable that may be exchanged,
//! excludes cycles (*New finite pivoting rules for the simplex method*, Mathematics of Operations
//! Research 2, 1977). Each bound may have a unit of its own, as may g·x; the x have one unit.

use nalgebra::{DMatrix, DVector};

/// Entries below this part of the largest of their bound, or of g, are none.
const PIVOT: f64 = 1e-9;
/// A shortfall below this part of the largest bound is none.
const ROUNDING: f64 = 1e-12;
/// Exchanges at most, for each variable.
const EXCHANGES: usize = 200;

/// A variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum LpVariable {
    /// s₀.
    Shortfall,
    Slack(usize),
    Free(usize),
}

/// `basic = constant + entries · others`; last among the rows are those of s₀ and g·x.
struct Dictionary {
    /// With the constants as the last column.
    entries: DMatrix<f64>,
    basic: Vec<LpVariable>,
    others: Vec<LpVariable>,
    /// What a constant is none below.
    none: f64,
    exchanges: usize,
}

/// What the value of a dictionary's function comes to.
#[derive(PartialEq)]
enum Course {
    Least,
    Endless,
}

/// The greatest lower bound of g·x, −∞ where there is none; nothing where no x is between the
/// bounds, or where numbers are not finite.
pub(crate) fn solve_linear_program(g: &DVector<f64>, a: &DMatrix<f64>, b: &DVector<f64>) -> Option<f64> {
    let (m, n) = a.shape();
    if g.iter().chain(a.iter()).chain(b.iter()).any(|x| !x.is_finite()) {
        return None;
    }
    let sizes: Vec<f64> = a.row_iter().map(|row| row.amax()).collect();
    // A bound of nothing holds, or it never does.
    if (0..m).any(|i| sizes[i] == 0.0 && b[i] > 0.0) {
        return None;
    }
    let balanced = |i: usize, x: f64| if sizes[i] > 0.0 { x / sizes[i] } else { 0.0 };
    let (a, b) = (
        DMatrix::from_fn(m, n, |i, k| balanced(i, a[(i, k)])),
        DVector::from_fn(m, |i, _| balanced(i, b[i])),
    );
    let size = g.amax();
    let g = if size > 0.0 { g / size } else { g.clone() };
    let mut dictionary = Dictionary::new(&a, &b, &g);
    let is_free = dictionary.exchange_free();
    dictionary.make_feasible()?;
    if is_free || dictionary.minimize(dictionary.basic.len() + 1)? == Course::Endless {
        return Some(f64::NEG_INFINITY);
    }
    let value = dictionary.vertex(&a, &b).map_or_else(|| dictionary.value(), |x| x.dot(&g));
    Some(if size > 0.0 { size * value } else { 0.0 })
}

impl Dictionary {
    fn new(a: &DMatrix<f64>, b: &DVector<f64>, g: &DVector<f64>) -> Self {
        let (m, n) = a.shape();
        let mut entries = DMatrix::zeros(m + 2, n + 2);
        entries.view_mut((0, 0), (m, n)).copy_from(a);
        entries[(m, n)] = 1.0;
        entries.view_mut((0, n + 1), (m, 1)).copy_from(&-b);
        entries.view_mut((m + 1, 0), (1, n)).copy_from(&g.transpose());
        let basic = (0..m).map(LpVariable::Slack).collect();
        let others = (0..n).map(LpVariable::Free).chain([LpVariable::Shortfall]).collect();
        let none = if m > 0 { ROUNDING * b.amax() } else { 0.0 };
        Self { entries, basic, others, none, exchanges: EXCHANGES * (m + n + 1) }
    }

    fn constant(&self, row: usize) -> f64 {
        self.entries[(row, self.others.len())]
    }

    fn value(&self) -> f64 {
        self.constant(self.basic.len() + 1)
    }

    /// Exchanges the x for slacks, the largest entry of all first; whether the value depends on one
    /// that no bound holds.
    fn exchange_free(&mut self) -> bool {
        let is_free = |variable: &LpVariable| matches!(variable, LpVariable::Free(_));
        loop {
            let columns: Vec<usize> = (0..self.others.len()).filter(|&k| is_free(&self.others[k])).collect();
            let rows = (0..self.basic.len()).filter(|&i| !is_free(&self.basic[i]));
            let places = rows.flat_map(|i| columns.iter().map(move |&k| (i, k)));
            let size = |place: &(usize, usize)| self.entries[*place].abs();
            match places.max_by(|p, q| size(p).total_cmp(&size(q))).filter(|place| size(place) > PIVOT) {
                Some((row, column)) => self.exchange(row, column),
                None => {
                    let value = self.basic.len() + 1;
                    return columns.iter().any(|&k| self.entries[(value, k)].abs() > PIVOT);
                }
            }
        }
    }

    /// Goes to constants that are not negative.
    fn make_feasible(&mut self) -> Option<()> {
        let slacks = (0..self.basic.len()).filter(|&i| matches!(self.basic[i], LpVariable::Slack(_)));
        let Some(least) = slacks.min_by(|&i, &k| self.constant(i).total_cmp(&self.constant(k))) else {
            return Some(());
        };
        let cover = self.others.iter().position(|other| *other == LpVariable::Shortfall)?;
        if self.constant(least) >= 0.0 {
            return Some(());
        }
        for row in (0..self.basic.len()).filter(|&i| matches!(self.basic[i], LpVariable::Slack(_))) {
            self.entries[(row, cover)] = 1.0;
        }
        self.exchange(least, cover);
        self.minimize(self.basic.len())?;
        let Some(row) = self.basic.iter().position(|basic| *basic == LpVariable::Shortfall) else {
            return Some(());
        };
        if self.constant(row) > self.none {
            return None;
        }
        // It is nothing, and so it is against any other.
        let size = |k: &usize| self.entries[(row, *k)].abs();
        let slacks = (0..self.others.len()).filter(|&k| matches!(self.others[k], LpVariable::Slack(_)));
        let column = slacks.max_by(|p, q| size(p).total_cmp(&size(q)))?;
        self.exchange(row, column);
        Some(())
    }

    /// Lessens the function of a row as far as it goes; nothing where that takes too long.
    fn minimize(&mut self, function: usize) -> Option<Course> {
        loop {
            let may_enter = |k: &usize| match self.others[*k] {
                LpVariable::Slack(_) => self.entries[(function, *k)] < -PIVOT,
                LpVariable::Shortfall | LpVariable::Free(_) => false,
            };
            let Some(column) = (0..self.others.len()).filter(may_enter).min_by_key(|&k| self.others[k])
            else {
                return Some(Course::Least);
            };
            let Some(row) = self.blocking(column) else { return Some(Course::Endless) };
            self.exchanges = self.exchanges.checked_sub(1)?;
            self.exchange(row, column);
        }
    }

    /// The row whose variable vanishes first as one that is not basic grows.
    fn blocking(&self, column: usize) -> Option<usize> {
        let falls =
            |i: &usize| !matches!(self.basic[*i], LpVariable::Free(_)) && self.entries[(*i, column)] < -PIVOT;
        let rows: Vec<usize> = (0..self.basic.len()).filter(falls).collect();
        let room = |row: usize| self.constant(row).max(0.0) / -self.entries[(row, column)];
        let least = rows.iter().map(|&row| room(row)).fold(f64::INFINITY, f64::min);
        let is_first = |row: &usize| (room(*row) - least) * -self.entries[(*row, column)] <= self.none;
        rows.into_iter().filter(is_first).min_by_key(|&row| self.basic[row])
    }

    /// Exchanges the basic variable of a row for that of a column.
    fn exchange(&mut self, row: usize, column: usize) {
        let pivot = self.entries[(row, column)];
        let mut solved = self.entries.row(row) / -pivot;
        solved[column] = 1.0 / pivot;
        for i in (0..self.entries.nrows()).filter(|&i| i != row) {
            let factor = self.entries[(i, column)];
            if factor != 0.0 {
                self.entries[(i, column)] = 0.0;
                let mut target = self.entries.row_mut(i);
                target += factor * &solved;
            }
        }
        self.entries.set_row(row, &solved);
        std::mem::swap(&mut self.basic[row], &mut self.others[column]);
    }

    /// The x at which all slacks that are not basic vanish, from the bounds as they are given:
    /// without the rounding of exchanges.
    fn vertex(&self, a: &DMatrix<f64>, b: &DVector<f64>) -> Option<DVector<f64>> {
        let slack = |variable: &LpVariable| if let LpVariable::Slack(i) = variable { Some(*i) } else { None };
        let free = |variable: &LpVariable| if let LpVariable::Free(k) = variable { Some(*k) } else { None };
        let rows: Vec<usize> = self.others.iter().filter_map(slack).collect();
        let columns: Vec<usize> = self.basic.iter().filter_map(free).collect();
        let mut x = DVector::zeros(a.ncols());
        if columns.is_empty() {
            return Some(x);
        }
        let matrix = a.select_rows(&rows).select_columns(&columns);
        let solved = matrix.full_piv_lu().solve(&b.select_rows(&rows))?;
        columns.iter().zip(&solved).for_each(|(&k, solved)| x[k] = *solved);
        Some(x)
    }
}

#[cfg(test)]
mod tests;
