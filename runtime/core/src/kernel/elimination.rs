//! The elimination, in memory that is lent.

use super::balance::{balance, balanced};
use super::lever::lever;
use super::refinement::{MatrixShape, refined};
use crate::model::{ContactSet, Friction, KernelView, Layout};
use crate::scalar::Scalar;

/// Memory for systems of `D` unknowns, of which `C` may be rows of constraints.
pub struct Room<S, const C: usize, const D: usize> {
    matrix: [[S; D]; D],
    basis: [[S; D]; D],
    vectors: [[S; D]; 3],
    columns: [[usize; D]; 2],
    rows: [usize; C],
}

impl<S: Scalar, const C: usize, const D: usize> Default for Room<S, C, D> {
    #[inline(always)]
    fn default() -> Self {
        let (vector, columns) = ([S::ZERO; D], [0; D]);
        Self {
            matrix: [vector; D],
            basis: [vector; D],
            vectors: [vector; 3],
            columns: [columns; 2],
            rows: [0; C],
        }
    }
}

impl<S: Scalar, const C: usize, const D: usize> Room<S, C, D> {
    /// What is lent.
    #[inline(always)]
    pub fn workspace(&mut self) -> Workspace<'_, S> {
        let [right, scale, solution] = &mut self.vectors;
        let [pivots, free] = &mut self.columns;
        Workspace {
            width: D,
            matrix: self.matrix.as_flattened_mut(),
            basis: self.basis.as_flattened_mut(),
            right,
            scale,
            solution,
            pivots,
            free,
            rows: &mut self.rows,
        }
    }
}

/// Memory for systems of up to `width` unknowns.
pub struct Workspace<'w, S> {
    width: usize,
    matrix: &'w mut [S],
    basis: &'w mut [S],
    right: &'w mut [S],
    scale: &'w mut [S],
    solution: &'w mut [S],
    pivots: &'w mut [usize],
    free: &'w mut [usize],
    rows: &'w mut [usize],
}

impl<'w, S> Workspace<'w, S> {
    /// Splits memory for `width` unknowns, of which `rows` may be rows of constraints:
    /// `2 width² + 3 width` numbers and `2 width + rows` indices. `None` where it is less.
    pub fn split(width: usize, rows: usize, numbers: &'w mut [S], indices: &'w mut [usize]) -> Option<Self> {
        let (matrix, rest) = numbers.split_at_mut_checked(width * width)?;
        let (basis, rest) = rest.split_at_mut_checked(width * width)?;
        let (right, rest) = rest.split_at_mut_checked(width)?;
        let (scale, rest) = rest.split_at_mut_checked(width)?;
        let solution = rest.get_mut(..width)?;
        let (pivots, rest) = indices.split_at_mut_checked(width)?;
        let (free, rest) = rest.split_at_mut_checked(width)?;
        let rows = rest.get_mut(..rows)?;
        Some(Self { width, matrix, basis, right, scale, solution, pivots, free, rows })
    }
}

/// The right-hand side.
#[derive(Clone, Copy)]
pub(super) enum Load<'a, S> {
    /// f and −b, with the friction of sliding contacts.
    Motion,
    /// 0 and −r, r of each row.
    Residual(&'a dyn Fn(usize) -> S),
}

/// The closed rows, accelerations with their multipliers, and whether these are unique.
#[inline(always)]
pub(super) fn solve<'w, S: Scalar>(
    workspace: Workspace<'w, S>,
    kernel: &impl KernelView<S>,
    layout: &Layout,
    set: &ContactSet,
    load: Load<'_, S>,
) -> (&'w [usize], &'w [S], bool) {
    let Workspace { width, matrix, basis, right, scale, solution, pivots, free, rows } = workspace;
    let accelerations = kernel.force().len();
    let mut count = 0;
    for row in (0..kernel.gap().len()).filter(|&row| layout.is_closed(row, set)) {
        rows[count] = row;
        count += 1;
    }
    let closed: &'w [usize] = &rows[..count];
    matrix.fill(S::ZERO);
    let mut system = LinearSystem { width, size: accelerations + count, matrix, right, scale };
    system.assemble(kernel, closed, load);
    if let Load::Motion = load {
        system.rub(kernel, layout, set, closed);
    }
    if S::DIFFERENTIATED && system.refine((basis, pivots), solution) {
        return (closed, solution, true);
    }
    let mut found = Rank { pivots, rank: 0, free, nullity: 0 };
    if !system.eliminate(accelerations, &mut found) {
        solution.fill(S::from_f64(f64::NAN));
        return (closed, solution, false);
    }
    let lever = if found.nullity == 0 {
        S::ratio(1, 1)
    } else {
        lever(layout, closed, |row, j| kernel.jacobian(row)[j], |j| kernel.mass(j)[j])
    };
    let weight = |k: usize| {
        if layout.is_turned(closed[k]) { S::ratio(1, 1) / (lever * lever) } else { S::ratio(1, 1) }
    };
    system.substitute(accelerations, &found, &weight, basis, solution);
    (closed, solution, found.nullity == 0)
}

/// A linear system in the first `size` rows and columns, balanced: `(S K S)(S⁻¹x) = S r` with S
/// diagonal.
struct LinearSystem<'w, S> {
    width: usize,
    size: usize,
    matrix: &'w mut [S],
    right: &'w mut [S],
    scale: &'w mut [S],
}

/// The columns with a pivot, in the order of their rows, and those without.
struct Rank<'w> {
    pivots: &'w mut [usize],
    rank: usize,
    free: &'w mut [usize],
    nullity: usize,
}

impl<S: Scalar> LinearSystem<'_, S> {
    #[inline(always)]
    fn entry(&self, i: usize, j: usize) -> S {
        self.matrix[i * self.width + j]
    }

    #[inline(always)]
    fn entry_mut(&mut self, i: usize, j: usize) -> &mut S {
        &mut self.matrix[i * self.width + j]
    }

    #[inline(always)]
    fn assemble(&mut self, kernel: &impl KernelView<S>, closed: &[usize], load: Load<'_, S>) {
        balance(kernel, closed, self.scale);
        let n = kernel.force().len();
        for i in 0..n {
            for j in 0..n {
                *self.entry_mut(i, j) = balanced(balanced(kernel.mass(i)[j], self.scale[i]), self.scale[j]);
            }
            self.right[i] = match load {
                Load::Motion => balanced(kernel.force()[i], self.scale[i]),
                Load::Residual(_) => S::ZERO,
            };
        }
        for (k, &row) in (n..).zip(closed) {
            for (j, &entry) in kernel.jacobian(row).iter().enumerate() {
                let entry = balanced(balanced(entry, self.scale[k]), self.scale[j]);
                *self.entry_mut(k, j) = entry;
                *self.entry_mut(j, k) = -entry;
            }
            let bias = match load {
                Load::Motion => kernel.bias()[row],
                Load::Residual(residual) => residual(row),
            };
            self.right[k] = balanced(-bias, self.scale[k]);
        }
    }

    /// The friction of sliding contacts, −σμ N along their slips.
    #[inline(always)]
    fn rub(&mut self, kernel: &impl KernelView<S>, layout: &Layout, set: &ContactSet, closed: &[usize]) {
        let n = kernel.force().len();
        for (_, Friction { contact, row, .. }) in layout.sliding(set) {
            let Some(k) = closed.iter().position(|closed| *closed == contact) else { continue };
            let force = balanced(kernel.friction()[row], self.scale[n + k]);
            for j in 0..n {
                let entry = balanced(kernel.jacobian(row)[j], self.scale[j]);
                *self.entry_mut(j, n + k) = entry.mul_add(force, self.entry(j, n + k));
            }
        }
    }

    /// Writes the solution by the factors of the values, where it is the only one; whether it is.
    #[inline(always)]
    fn refine(&mut self, room: (&mut [S], &mut [usize]), solution: &mut [S]) -> bool {
        let shape = MatrixShape { size: self.size, width: self.width };
        let rounding = self.rounding().to_f64();
        solution.fill(S::ZERO);
        if !refined(shape, self.matrix, self.right, rounding, room, solution) {
            return false;
        }
        self.unbalance(solution);
        true
    }

    /// A pivot no larger than this is zero.
    #[inline(always)]
    fn rounding(&self) -> S {
        S::EPSILON * S::ratio(8 * self.size as i64, 1)
    }

    /// Upper echelon form; whether all accelerations are determined.
    #[inline(always)]
    fn eliminate(&mut self, accelerations: usize, found: &mut Rank<'_>) -> bool {
        let rounding = self.rounding();
        for column in 0..self.size {
            let top = found.rank;
            let pivot = self.largest(column, top);
            let weight = self.entry(pivot, column).abs();
            if weight > rounding {
                self.swap(top, pivot);
                self.clear_below(top, column);
                found.pivots[top] = column;
                found.rank += 1;
            } else if column >= accelerations && weight <= rounding {
                found.free[found.nullity] = column;
                found.nullity += 1;
            } else {
                return false;
            }
        }
        true
    }

    #[inline(always)]
    fn largest(&self, column: usize, top: usize) -> usize {
        let weight = |row: usize| self.entry(row, column).abs();
        (top..self.size).fold(top, |best, row| if weight(row) > weight(best) { row } else { best })
    }

    #[inline(always)]
    fn swap(&mut self, top: usize, pivot: usize) {
        if top != pivot {
            for j in 0..self.size {
                self.matrix.swap(top * self.width + j, pivot * self.width + j);
            }
            self.right.swap(top, pivot);
        }
    }

    #[inline(always)]
    fn clear_below(&mut self, top: usize, column: usize) {
        let (above, below) = self.matrix.split_at_mut((top + 1) * self.width);
        let above = &above[top * self.width..][..self.size];
        for (row, entries) in (top + 1..self.size).zip(below.chunks_exact_mut(self.width)) {
            let entries = &mut entries[..self.size];
            let factor = -entries[column] / above[column];
            for j in column..self.size {
                entries[j] = above[j].mul_add(factor, entries[j]);
            }
            self.right[row] = self.right[top].mul_add(factor, self.right[row]);
        }
    }

    /// Writes the solution whose reactions, the entries from `accelerations` on, have the least sum
    /// of squares by their weights.
    #[inline(always)]
    fn substitute(
        &self,
        accelerations: usize,
        found: &Rank<'_>,
        weight: &impl Fn(usize) -> S,
        basis: &mut [S],
        solution: &mut [S],
    ) {
        solution.fill(S::ZERO);
        self.back(found, solution, S::ratio(1, 1));
        self.unbalance(solution);
        for k in 0..found.nullity {
            let (earlier, rest) = basis.split_at_mut(k * self.width);
            let direction = &mut rest[..self.width];
            direction.fill(S::ZERO);
            direction[found.free[k]] = S::ratio(1, 1);
            self.back(found, direction, S::ZERO);
            self.unbalance(direction);
            for known in earlier.chunks_exact(self.width) {
                remove(known, direction, (accelerations, self.size), weight);
            }
            remove(direction, solution, (accelerations, self.size), weight);
        }
    }

    #[inline(always)]
    fn unbalance(&self, x: &mut [S]) {
        for (x, scale) in x.iter_mut().zip(self.scale.iter()) {
            *x = balanced(*x, *scale);
        }
    }

    /// Back substitution of the pivot columns with `load` times the right-hand side, the free ones
    /// as given.
    #[inline(always)]
    fn back(&self, found: &Rank<'_>, x: &mut [S], load: S) {
        for row in (0..found.rank).rev() {
            let column = found.pivots[row];
            let mut rest = self.right[row] * load;
            let entries = &self.matrix[row * self.width..][..self.size];
            for (entry, x) in entries.iter().zip(x.iter()).skip(column + 1) {
                rest = (-*entry).mul_add(*x, rest);
            }
            x[column] = rest / entries[column];
        }
    }
}

/// Makes the reactions of `x`, from `start` to `end`, orthogonal to those of `direction`, squares
/// by their weights.
#[inline(always)]
fn remove<S: Scalar>(
    direction: &[S],
    x: &mut [S],
    (start, end): (usize, usize),
    weight: &impl Fn(usize) -> S,
) {
    let along =
        |y: &[S]| (start..end).fold(S::ZERO, |sum, j| (direction[j] * weight(j - start)).mul_add(y[j], sum));
    let factor = -(along(x) / along(direction));
    for j in start..end {
        x[j] = direction[j].mul_add(factor, x[j]);
    }
}
