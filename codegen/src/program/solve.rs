//! `M a = f` for a symmetric M over named entries: Cramer's rule for two unknowns, `L D Lᵀ` beyond.

use super::{Id, Program};

/// Solves for `a`; `mass[i][j]` is read for `j ≤ i`.
pub fn solve_symmetric(program: &mut Program, mass: &[Vec<Id>], force: &[Id]) -> Vec<Id> {
    match force.len() {
        0 => Vec::new(),
        1 => vec![program.div(force[0], mass[0][0])],
        2 if !program.is_zero(mass[1][0]) => cramer(program, mass, force),
        _ => Factored::factor(program, mass).solve(program, force),
    }
}

fn cramer(program: &mut Program, mass: &[Vec<Id>], force: &[Id]) -> Vec<Id> {
    let (a, b, c) = (mass[0][0], mass[1][0], mass[1][1]);
    let mut determinant = |a: Id, d: Id, b: Id, c: Id| {
        let bc = program.mul(b, c);
        let minus = program.neg(bc);
        program.mul_add(a, d, minus)
    };
    let whole = determinant(a, c, b, b);
    let first = determinant(c, force[0], b, force[1]);
    let second = determinant(a, force[1], b, force[0]);
    let one = program.integer(1);
    let inverse = program.div(one, whole);
    vec![program.mul(first, inverse), program.mul(second, inverse)]
}

/// `M = L D Lᵀ`.
#[derive(Default)]
pub struct Factored {
    lower: Vec<Vec<Id>>,
    inverse: Vec<Id>,
    /// D.
    pub pivots: Vec<Id>,
    /// What the first rows leave of the diagonal, of one of these its entry.
    pub diagonal: Vec<Id>,
}

impl Factored {
    /// `w_ij = m_ij − Σ w_ik l_jk`, `l_ij = w_ij / d_j`, `d_i = m_ii − Σ w_ik l_ik`; `mass[i][j]`
    /// is read for `j ≤ i`.
    pub fn factor(program: &mut Program, mass: &[Vec<Id>]) -> Self {
        Self::bordered(program, mass, 0)
    }

    /// The same of a matrix whose first rows are definite, and the others in what these leave.
    pub fn bordered(program: &mut Program, mass: &[Vec<Id>], first: usize) -> Self {
        let one = program.integer(1);
        let mut factored = Self::default();
        for (i, entries) in mass.iter().enumerate() {
            let mut scaled: Vec<Id> = Vec::with_capacity(i);
            let mut row: Vec<Id> = Vec::with_capacity(i);
            for (j, &entry) in entries.iter().enumerate().take(i) {
                let products = scaled.iter().copied().zip(factored.lower[j].iter().copied());
                let entry = less(program, entry, products.collect());
                scaled.push(entry);
                row.push(program.mul(entry, factored.inverse[j]));
            }
            let mut products: Vec<(Id, Id)> = scaled.into_iter().zip(row.iter().copied()).collect();
            let among = products.split_off(if i < first { 0 } else { first.min(i) });
            let left = less(program, entries[i], products);
            let pivot = less(program, left, among);
            factored.diagonal.push(left);
            factored.pivots.push(pivot);
            factored.inverse.push(program.div(one, pivot));
            factored.lower.push(row);
        }
        factored
    }

    /// a of `M a = f`.
    pub fn solve(&self, program: &mut Program, force: &[Id]) -> Vec<Id> {
        let n = force.len();
        let mut forward: Vec<Id> = Vec::with_capacity(n);
        for (row, &force) in self.lower.iter().zip(force) {
            let products = row.iter().copied().zip(forward.iter().copied()).collect();
            forward.push(less(program, force, products));
        }
        let mut result: Vec<Id> = (0..n).map(|i| program.mul(forward[i], self.inverse[i])).collect();
        for i in (0..n).rev() {
            let products = (i + 1..n).map(|k| (self.lower[k][i], result[k])).collect();
            result[i] = less(program, result[i], products);
        }
        result
    }
}

/// a − Σ bᵢ cᵢ.
fn less(program: &mut Program, a: Id, products: Vec<(Id, Id)>) -> Id {
    products.into_iter().fold(a, |rest, (b, c)| {
        let minus = program.neg(b);
        program.mul_add(minus, c, rest)
    })
}
