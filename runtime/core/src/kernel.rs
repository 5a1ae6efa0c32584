//! Masked equations of motion: over the closed rows of a [`Kernel`],
//!
//! ```text
//! [ M  −Jᵀ ] [ a ]   [  f ]
//! [ J   0  ] [ λ ] = [ −b ]
//! ```
//!
//! (with friction the column of a sliding contact is −(J_N − σμ J_t)ᵀ) by elimination with partial pivoting of the system balanced to unit inertias and unit constraint rows, so that a
//! massless row (a row of M that vanishes) is never a pivot where a constraint can be one. Redundant constraints
//! leave columns without a pivot; of the reactions the least-norm ones are returned. A singular system
//! gives NaN, which the integrator refuses. Nothing allocates.

mod emitted;

pub use emitted::{mass_by_paths, trusted};

use crate::model::{ContactSet, Friction, Kernel, Layout};
use crate::scalar::Scalar;

/// Time derivative of the full state, `Y` entries: rates, then accelerations with the rows of `set` closed, then 1 for
/// the time if it is a part of the state.
pub fn derivative<S, const N: usize, const C: usize, const D: usize, const Y: usize>(
    kernel: &Kernel<S, N, C, D>,
    layout: &Layout,
    set: &ContactSet,
    state: &[S; Y],
) -> [S; Y]
where
    S: Scalar,
{
    let (_, solution, _) = solve(kernel, layout, set);
    core::array::from_fn(|i| match i {
        _ if i < N => state[N + i],
        _ if i < 2 * N => solution[i - N],
        _ => S::ratio(1, 1),
    })
}

/// Reactions of the contacts, zero where open, then the friction forces; `R` in all.
pub fn reactions<S, const N: usize, const C: usize, const D: usize, const R: usize>(
    kernel: &Kernel<S, N, C, D>,
    layout: &Layout,
    set: &ContactSet,
) -> [S; R]
where
    S: Scalar,
{
    if set.is_empty() {
        return [S::ZERO; R];
    }
    let multipliers = solution(kernel, layout, set).multipliers;
    core::array::from_fn(|entry| multipliers[layout.row_of_reaction(entry)])
}

/// Accelerations, and the multiplier of every row, zero where open.
pub(crate) struct Solution<S, const N: usize, const C: usize> {
    pub(crate) accelerations: [S; N],
    pub(crate) multipliers: [S; C],
    /// Whether the multipliers are the only ones.
    pub(crate) unique: bool,
}

/// The motion with the rows of `set` closed.
pub(crate) fn solution<S: Scalar, const N: usize, const C: usize, const D: usize>(
    kernel: &Kernel<S, N, C, D>,
    layout: &Layout,
    set: &ContactSet,
) -> Solution<S, N, C> {
    let (rows, solution, unique) = solve(kernel, layout, set);
    let mut multipliers = [S::ZERO; C];
    for (k, &row) in rows.closed().iter().enumerate() {
        multipliers[row] = solution[N + k];
    }
    for (_, friction) in layout.sliding(set) {
        multipliers[friction.row] = -kernel.friction[friction.row] * multipliers[friction.contact];
    }
    let accelerations = core::array::from_fn(|i| solution[i]);
    Solution { accelerations, multipliers, unique }
}

/// The closed rows in ascending order.
struct Rows<const C: usize> {
    index: [usize; C],
    count: usize,
}

impl<const C: usize> Rows<C> {
    fn new(layout: &Layout, set: &ContactSet) -> Self {
        let mut rows = Self { index: [0; C], count: 0 };
        for row in (0..C).filter(|&row| layout.is_closed(row, set)) {
            rows.index[rows.count] = row;
            rows.count += 1;
        }
        rows
    }

    fn closed(&self) -> &[usize] {
        &self.index[..self.count]
    }
}

/// The closed rows, accelerations with their multipliers, and whether these are unique.
fn solve<S: Scalar, const N: usize, const C: usize, const D: usize>(
    kernel: &Kernel<S, N, C, D>,
    layout: &Layout,
    set: &ContactSet,
) -> (Rows<C>, [S; D], bool) {
    let rows = Rows::new(layout, set);
    let mut system = System::<S, D>::assemble(kernel, rows.closed());
    system.rub(kernel, layout, set, rows.closed());
    match system.eliminate(N) {
        Some(rank) => (rows, system.substitute(N, &rank), rank.nullity == 0),
        None => (rows, [S::from_f64(f64::NAN); D], false),
    }
}

/// A linear system in the first `size` rows and columns, balanced: `(S K S)(S⁻¹x) = S r` with S diagonal.
struct System<S, const D: usize> {
    size: usize,
    matrix: [[S; D]; D],
    right: [S; D],
    scale: [S; D],
}

/// The columns with a pivot, in the order of their rows, and those without.
struct Rank<const D: usize> {
    pivots: [usize; D],
    rank: usize,
    free: [usize; D],
    nullity: usize,
}

impl<S: Scalar, const D: usize> System<S, D> {
    fn assemble<const N: usize, const C: usize>(kernel: &Kernel<S, N, C, D>, closed: &[usize]) -> Self {
        let scale = balance(kernel, closed);
        let size = N + closed.len();
        let mut matrix = [[S::ZERO; D]; D];
        let mut right = [S::ZERO; D];
        for i in 0..N {
            for j in 0..N {
                matrix[i][j] = kernel.mass[i][j] * scale[i] * scale[j];
            }
            right[i] = kernel.force[i] * scale[i];
        }
        for (k, &row) in (N..).zip(closed) {
            for (j, &entry) in kernel.jacobian[row].iter().enumerate() {
                matrix[k][j] = entry * scale[k] * scale[j];
                matrix[j][k] = -matrix[k][j];
            }
            right[k] = -kernel.bias[row] * scale[k];
        }
        Self { size, matrix, right, scale }
    }

    /// The friction of sliding contacts, −σμ N along their slips.
    fn rub<const N: usize, const C: usize>(
        &mut self,
        kernel: &Kernel<S, N, C, D>,
        layout: &Layout,
        set: &ContactSet,
        closed: &[usize],
    ) {
        for (_, Friction { contact, row }) in layout.sliding(set) {
            let Some(k) = closed.iter().position(|closed| *closed == contact) else { continue };
            let force = kernel.friction[row] * self.scale[N + k];
            for j in 0..N {
                let entry = kernel.jacobian[row][j] * self.scale[j];
                self.matrix[j][N + k] = entry.mul_add(force, self.matrix[j][N + k]);
            }
        }
    }

    /// Upper echelon form; `None` if an acceleration is undetermined.
    fn eliminate(&mut self, accelerations: usize) -> Option<Rank<D>> {
        let rounding = S::EPSILON * S::ratio(8 * self.size as i64, 1);
        let mut found = Rank { pivots: [0; D], rank: 0, free: [0; D], nullity: 0 };
        for column in 0..self.size {
            let top = found.rank;
            let pivot = self.largest(column, top);
            let weight = self.matrix[pivot][column].abs();
            if weight > rounding {
                self.matrix.swap(top, pivot);
                self.right.swap(top, pivot);
                self.clear_below(top, column);
                found.pivots[top] = column;
                found.rank += 1;
            } else if column >= accelerations && weight <= rounding {
                found.free[found.nullity] = column;
                found.nullity += 1;
            } else {
                return None;
            }
        }
        Some(found)
    }

    fn largest(&self, column: usize, top: usize) -> usize {
        let weight = |row: usize| self.matrix[row][column].abs();
        (top..self.size).fold(top, |best, row| if weight(row) > weight(best) { row } else { best })
    }

    fn clear_below(&mut self, top: usize, column: usize) {
        for row in top + 1..self.size {
            let factor = -self.matrix[row][column] / self.matrix[top][column];
            for j in column..self.size {
                self.matrix[row][j] = self.matrix[top][j].mul_add(factor, self.matrix[row][j]);
            }
            self.right[row] = self.right[top].mul_add(factor, self.right[row]);
        }
    }

    /// The solution whose reactions, the entries from `accelerations` on, have the least norm.
    fn substitute(&self, accelerations: usize, found: &Rank<D>) -> [S; D] {
        let mut solution = [S::ZERO; D];
        self.back(found, &mut solution, S::ratio(1, 1));
        self.unbalance(&mut solution);
        let mut basis = [[S::ZERO; D]; D];
        for k in 0..found.nullity {
            basis[k][found.free[k]] = S::ratio(1, 1);
            self.back(found, &mut basis[k], S::ZERO);
            self.unbalance(&mut basis[k]);
            let (earlier, rest) = basis.split_at_mut(k);
            for direction in earlier {
                remove(direction, &mut rest[0], accelerations);
            }
            remove(&basis[k], &mut solution, accelerations);
        }
        solution
    }

    fn unbalance(&self, x: &mut [S; D]) {
        for (x, scale) in x.iter_mut().zip(self.scale) {
            *x = *x * scale;
        }
    }

    /// Back substitution of the pivot columns with `load` times the right-hand side, the free ones as given.
    fn back(&self, found: &Rank<D>, x: &mut [S; D], load: S) {
        for row in (0..found.rank).rev() {
            let column = found.pivots[row];
            let mut rest = self.right[row] * load;
            for (entry, x) in self.matrix[row].iter().zip(x.iter()).take(self.size).skip(column + 1) {
                rest = (-*entry).mul_add(*x, rest);
            }
            x[column] = rest / self.matrix[row][column];
        }
    }
}

/// Makes the tail of `x` from `start` on orthogonal to that of `direction`.
fn remove<S: Scalar, const D: usize>(direction: &[S; D], x: &mut [S; D], start: usize) {
    let along = |y: &[S; D]| (start..D).fold(S::ZERO, |sum, j| direction[j].mul_add(y[j], sum));
    let factor = -(along(x) / along(direction));
    for j in start..D {
        x[j] = direction[j].mul_add(factor, x[j]);
    }
}

/// Factors that make the diagonal of M one, then the largest entry of each closed row of J.
fn balance<S: Scalar, const N: usize, const C: usize, const D: usize>(
    kernel: &Kernel<S, N, C, D>,
    closed: &[usize],
) -> [S; D] {
    let mut scale = [S::ratio(1, 1); D];
    for (j, factor) in scale.iter_mut().enumerate().take(N) {
        let inertia = kernel.mass[j][j];
        let column = closed.iter().map(|&row| kernel.jacobian[row][j]);
        *factor = reciprocal(if inertia > S::ZERO { inertia.sqrt() } else { largest(column) });
    }
    for (k, &row) in (N..).zip(closed) {
        scale[k] = reciprocal(largest((0..N).map(|j| kernel.jacobian[row][j] * scale[j])));
    }
    scale
}

fn largest<S: Scalar>(entries: impl Iterator<Item = S>) -> S {
    entries.fold(S::ZERO, |most, x| if x.abs() > most { x.abs() } else { most })
}

/// `1 / x`, and 1 for zero.
fn reciprocal<S: Scalar>(x: S) -> S {
    if x > S::ZERO { S::ratio(1, 1) / x } else { S::ratio(1, 1) }
}
