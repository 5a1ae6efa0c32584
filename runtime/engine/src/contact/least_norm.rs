//! Reactions that are not unique: of all that hold the same motion, the shortest,
//!
//! ```text
//! ½ |λ|² → min,    Jᵀ λ = F,    λ ≥ 0 where one-sided
//! ```
//!
//! whose dual has the dimension of the motion alone: λ = J y where two-sided and (J y)₊ where one-sided, with `Jᵀ λ(y) = F`
//! solved by Newton's method with a line search (Qi and Sun, *A nonsmooth version of Newton's method*, Math. Programming 58,
//! 1993).

use nalgebra::{DMatrix, DVector};

use super::closed_rows::ClosedRows;
use super::complementarity::Solution;
use super::equilibrated_kkt::EquilibratedKkt;
use super::friction::shortest_within_cones;
use crate::integration::phase_point::Numbers;
use crate::model::ContactSet;
use crate::system::System;

/// Newton steps at most; of what it does not reach by then, the reactions of the bearing contacts are left.
const STEPS: usize = 100;
/// Residual of Jᵀ λ = F relative to F.
const SOLVED: f64 = 1e-13;
/// Halvings of a step.
const HALVINGS: usize = 40;

/// The multipliers of all rows given some that hold the same motion, the shortest with the contacts of a set closed.
pub(crate) fn shortest_reactions(
    system: &dyn System,
    state: &[f64],
    closed: ContactSet,
    held: &[f64],
) -> Numbers {
    let layout = system.layout();
    if !layout.frictions.is_empty() {
        return shortest_within_cones(system, state, &closed, held);
    }
    let ClosedRows { rows, jacobian } = ClosedRows::of(system, state, &closed);
    let load = jacobian.tr_mul(&DVector::from_fn(rows.len(), |k, _| held[rows[k]]));
    let one_sided = |row: usize| row < layout.contacts.len();
    let shares = Shares { jacobian, load, rows: &rows, one_sided: &one_sided };
    let mut reactions = Numbers::from_slice(held);
    if let Some(shortest) = shares.shortest() {
        rows.iter().zip(shortest.iter()).for_each(|(&row, &share)| reactions[row] = share);
    }
    reactions
}

/// J in natural coordinates and own units of the rows, and F.
struct Shares<'a> {
    jacobian: DMatrix<f64>,
    load: DVector<f64>,
    rows: &'a [usize],
    one_sided: &'a dyn Fn(usize) -> bool,
}

impl EquilibratedKkt {
    /// λ of every row, the shortest of those that hold the motion of a solution.
    pub(super) fn share(&self, found: &Solution, one_sided: &dyn Fn(usize) -> bool) -> DVector<f64> {
        if found.unique {
            return found.reactions.clone();
        }
        let jacobian = self.rows_in_own_units(&found.tight);
        let held = DVector::from_fn(found.tight.len(), |k, _| found.reactions[found.tight[k]]);
        let load = jacobian.tr_mul(&held);
        let shares = Shares { jacobian, load, rows: &found.tight, one_sided };
        let mut reactions = found.reactions.clone();
        if let Some(shortest) = shares.shortest() {
            found.tight.iter().zip(shortest.iter()).for_each(|(&row, &share)| reactions[row] = share);
        }
        reactions
    }
}

impl Shares<'_> {
    fn shortest(&self) -> Option<DVector<f64>> {
        let size = self.load.norm();
        let mut y = self.step(&DVector::from_element(self.rows.len(), 1.0), &self.load)?;
        for _ in 0..STEPS {
            let reactions = self.reactions(&y);
            let rest = &self.load - self.jacobian.tr_mul(&reactions);
            if rest.norm() <= SOLVED * size {
                return Some(reactions);
            }
            let acts =
                DVector::from_fn(reactions.len(), |k, _| if self.acts(k, reactions[k]) { 1.0 } else { 0.0 });
            let step = self.step(&acts, &rest)?;
            y = self.descend(&y, &step, rest.dot(&step));
        }
        None
    }

    fn acts(&self, place: usize, reaction: f64) -> bool {
        reaction > 0.0 || !(self.one_sided)(self.rows[place])
    }

    /// λ(y).
    fn reactions(&self, y: &DVector<f64>) -> DVector<f64> {
        let unsigned = &self.jacobian * y;
        DVector::from_fn(unsigned.len(), |k, _| if self.acts(k, unsigned[k]) { unsigned[k] } else { 0.0 })
    }

    /// Newton's step with the rows that act: Jᵀ D J Δy = r, of least norm where that is not unique.
    fn step(&self, acts: &DVector<f64>, rest: &DVector<f64>) -> Option<DVector<f64>> {
        let held = DMatrix::from_fn(self.jacobian.nrows(), self.jacobian.ncols(), |k, j| {
            acts[k] * self.jacobian[(k, j)]
        });
        let curvature = held.tr_mul(&self.jacobian);
        let svd = curvature.svd(true, true);
        let cutoff = 64.0 * f64::EPSILON * svd.singular_values.amax();
        svd.solve(rest, cutoff).ok()
    }

    /// The longest of the halved steps that lowers ½ |λ|² − F·y; `slope` is what the whole one would gain.
    fn descend(&self, y: &DVector<f64>, step: &DVector<f64>, slope: f64) -> DVector<f64> {
        let value = |y: &DVector<f64>| 0.5 * self.reactions(y).norm_squared() - self.load.dot(y);
        let now = value(y);
        let shorter = (0..HALVINGS).map(|k| 0.5f64.powi(k as i32));
        let mut tried = shorter.map(|part| (part, y + step * part));
        let lower = tried.find(|(part, ahead)| value(ahead) <= now - 1e-4 * part * slope);
        lower.map_or_else(|| y + step, |(_, ahead)| ahead)
    }
}
