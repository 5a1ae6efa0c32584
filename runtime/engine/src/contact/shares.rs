//! Reactions that are not unique: of all that hold the same motion, the shortest,
//!
//! ```text
//! ½ |λ|² → min,    Jᵀ λ = F,    λ ∈ K
//! ```
//!
//! with K the product of a contact's cone `|R| ≤ μ_s λ_N` while it sticks, its edge `R = −σ μ λ_N`
//! while it slides, λ ≥ 0 of contacts without friction, and all of two-sided rows; of a couple c at
//! the lever ℓ of [`liftoff_core::kernel::lever`] λ is c/ℓ. The dual has the dimension of the
//! motion alone: λ is the projection of J y on K, and `Jᵀ λ(y) = F` is solved by Newton's method
//! with a line search (Qi and Sun, *A nonsmooth version of Newton's method*, Math. Programming 58,
//! 1993). What it does not reach is found face by face ([`faces`]).

use std::cell::LazyCell;

use nalgebra::{DMatrix, DVector};

use super::closed_rows::ClosedRows;
use super::complementarity::Solution;
use super::equilibrated_kkt::EquilibratedKkt;
use crate::context::{Numbers, slips};
use crate::model::{ContactSet, Side, Slip};
use crate::numerics::decomposition::svd;
use crate::numerics::zero::roundoff;
use crate::system::System;

/// Newton steps at most.
const STEPS: usize = 20;
/// Residual of Jᵀ λ = F relative to F.
const SOLVED: f64 = 1e-13;
/// Halvings of a step.
const HALVINGS: usize = 40;
/// A step that lowers the dual by less than this part of its terms is as good as its rounding lets
/// it be told.
const ROUNDING: f64 = roundoff(16.0);

/// A factor of K that is not all of its space, with the places of its rows.
#[derive(Debug, Clone, Copy)]
pub(super) enum Factor {
    /// λ ≥ 0.
    Pressing(usize),
    /// |R| ≤ μ_s λ_N.
    Cone { normal: usize, tangent: usize, limit: f64 },
    /// R = slope λ_N, λ_N ≥ 0.
    Edge { normal: usize, tangent: usize, slope: f64 },
}

/// J of closed rows in natural coordinates and own units, and F.
struct Shares {
    jacobian: DMatrix<f64>,
    load: DVector<f64>,
    factors: Vec<Factor>,
}

/// The multipliers of all rows given some that hold the same motion with the contacts of a set
/// closed, the shortest of those. The search begins with the `dual` y of a motion before, and
/// leaves its own.
pub(crate) fn shortest_reactions(
    system: &dyn System,
    state: &[f64],
    closed: &ContactSet,
    held: &[f64],
    dual: &mut Option<DVector<f64>>,
) -> Numbers {
    let layout = system.layout();
    let closed_rows = ClosedRows::compute(system, state, closed);
    let slips = slips(system, state);
    let contacts = closed.iter().filter_map(|contact| Some((contact, closed_rows.find_index(contact)?)));
    let factor = |(contact, normal): (usize, usize)| {
        let friction = layout.contacts[contact].friction;
        let tangent =
            friction.and_then(|entry| Some((entry, closed_rows.find_index(layout.frictions[entry].row)?)));
        match tangent {
            None => Factor::Pressing(normal),
            Some((entry, tangent)) => match closed.slip(contact) {
                Slip::Stick => Factor::Cone { normal, tangent, limit: slips[entry].limit },
                slip => {
                    Factor::Edge { normal, tangent, slope: -f64::from(slip.sign()) * slips[entry].kinetic }
                }
            },
        }
    };
    let factors = contacts.map(factor).collect();
    let mut reactions = Numbers::from_slice(held);
    let negative: Vec<usize> = closed.iter().filter(|i| closed.side(*i) == Side::Negative).collect();
    share(closed_rows, factors, &negative, (&mut reactions, dual));
    reactions
}

/// Shares the load of rows anew; those of `negative` press with λ < 0.
pub(super) fn share(
    closed: ClosedRows,
    factors: Vec<Factor>,
    negative: &[usize],
    (reactions, dual): (&mut [f64], &mut Option<DVector<f64>>),
) {
    let sign = |k: usize| if negative.contains(&closed.rows[k]) { -1.0 } else { 1.0 };
    let undetermined = LazyCell::new(|| closed.undetermined());
    // A determined reaction that pulls, by rounding, presses nothing.
    let pulls = |k: &usize| sign(*k) * reactions[closed.rows[*k]] < 0.0 && !undetermined[*k];
    let kept: Vec<usize> = factors.iter().map(Factor::pressing).filter(pulls).collect();
    // A couple that the motion determines is shared with none, and at a small lever it would be lost.
    let lever = |k: usize| {
        let own = closed.levers[k];
        if own != 1.0 && !undetermined[k] { 1.0 } else { own }
    };
    let levers: Vec<f64> = (0..closed.rows.len()).map(lever).collect();
    let ClosedRows { rows, mut jacobian, .. } = closed;
    let held = |k: usize| if kept.contains(&k) { 0.0 } else { reactions[rows[k]] };
    let load = jacobian.tr_mul(&DVector::from_fn(rows.len(), |k, _| held(k)));
    for (k, _) in rows.iter().enumerate().filter(|(_, row)| negative.contains(row)) {
        jacobian.row_mut(k).neg_mut();
    }
    // A couple c is ℓ times the force of its share.
    levers.iter().enumerate().for_each(|(k, lever)| jacobian.row_mut(k).scale_mut(*lever));
    let shares = Shares { jacobian, load, factors };
    let near = dual.take().and_then(|y| shares.shortest_from(y));
    let found = near.or_else(|| shares.shortest()).or_else(|| shares.shortest_on_faces());
    if let Some((shortest, y)) = found {
        *dual = Some(y);
        for (k, &row) in rows.iter().enumerate().filter(|(k, _)| !kept.contains(k)) {
            reactions[row] = levers[k] * if negative.contains(&row) { -shortest[k] } else { shortest[k] };
        }
    }
}

impl EquilibratedKkt {
    /// λ of every row, the shortest of those that hold the motion of a solution.
    pub(super) fn share(&self, found: &Solution, one_sided: &dyn Fn(usize) -> bool) -> DVector<f64> {
        let mut reactions = found.reactions.clone();
        if !found.unique {
            let rows = &found.tight;
            let pressing = (0..rows.len()).filter(|&place| one_sided(rows[place]));
            let factors = pressing.map(Factor::Pressing).collect();
            share(self.closed_rows(rows.clone()), factors, &[], (reactions.as_mut_slice(), &mut None));
        }
        reactions
    }
}

impl Factor {
    /// The place of what presses.
    fn pressing(&self) -> usize {
        match *self {
            Self::Pressing(place) => place,
            Self::Cone { normal, .. } | Self::Edge { normal, .. } => normal,
        }
    }

    /// Projects the entries of x, and the rows of a matrix with the derivative there.
    fn project(&self, x: &mut DVector<f64>, rows: &mut DMatrix<f64>) {
        match *self {
            Self::Pressing(place) => {
                if x[place] <= 0.0 {
                    x[place] = 0.0;
                    rows.row_mut(place).fill(0.0);
                }
            }
            Self::Edge { normal, tangent, slope } => to_edge((normal, tangent), slope, x, rows),
            Self::Cone { normal, tangent, limit } => {
                if x[tangent].abs() > limit * x[normal] {
                    to_edge((normal, tangent), limit * x[tangent].signum(), x, rows);
                }
            }
        }
    }
}

/// Projection on the half-line λ_N (1, slope), λ_N ≥ 0.
fn to_edge((normal, tangent): (usize, usize), slope: f64, x: &mut DVector<f64>, rows: &mut DMatrix<f64>) {
    let part = 1.0 / (1.0 + slope * slope);
    let along = (x[normal] + slope * x[tangent]) * part;
    let acts = if along > 0.0 { 1.0 } else { 0.0 };
    (x[normal], x[tangent]) = (acts * along, acts * slope * along);
    let row = (rows.row(normal) + rows.row(tangent) * slope) * (part * acts);
    rows.set_row(tangent, &(&row * slope));
    rows.set_row(normal, &row);
}

impl Shares {
    /// λ and y from those without conditions on.
    fn shortest(&self) -> Option<(DVector<f64>, DVector<f64>)> {
        self.shortest_from(step(&self.jacobian, &self.jacobian, &self.load)?)
    }

    fn shortest_from(&self, mut y: DVector<f64>) -> Option<(DVector<f64>, DVector<f64>)> {
        let size = self.load.norm();
        for _ in 0..STEPS {
            let (reactions, derivative) = self.reactions(&y);
            let rest = &self.load - self.jacobian.tr_mul(&reactions);
            if rest.norm() <= SOLVED * size {
                return Some((reactions, y));
            }
            let step = step(&self.jacobian, &derivative, &rest)?;
            y = self.descend(&y, &step, rest.dot(&step));
        }
        None
    }

    /// λ(y), and its derivative.
    fn reactions(&self, y: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
        let (mut x, mut rows) = (&self.jacobian * y, self.jacobian.clone());
        self.factors.iter().for_each(|factor| factor.project(&mut x, &mut rows));
        (x, rows)
    }

    /// The longest of the halved steps that lowers ½ |λ|² − F·y, as far as that is known; `slope`
    /// is what the whole one would gain.
    fn descend(&self, y: &DVector<f64>, step: &DVector<f64>, slope: f64) -> DVector<f64> {
        let terms = |y: &DVector<f64>| (0.5 * self.reactions(y).0.norm_squared(), self.load.component_mul(y));
        let value = |y: &DVector<f64>| {
            let (length, work) = terms(y);
            length - work.sum()
        };
        let (length, work) = terms(y);
        let most = length - work.sum() + ROUNDING * (length + work.abs().sum());
        let mut tried = (0..HALVINGS).map(|k| 0.5f64.powi(k as i32)).map(|part| (part, y + step * part));
        let lower = tried.find(|(part, ahead)| value(ahead) <= most - 1e-4 * part * slope);
        lower.map_or_else(|| y + step, |(_, ahead)| ahead)
    }
}

/// Newton's step Jᵀ λ' Δy = r, of least norm where that is not unique.
fn step(jacobian: &DMatrix<f64>, derivative: &DMatrix<f64>, rest: &DVector<f64>) -> Option<DVector<f64>> {
    let svd = svd(jacobian.tr_mul(derivative));
    let cutoff = 64.0 * f64::EPSILON * svd.singular_values.amax();
    svd.solve(rest, cutoff).ok()
}

mod faces;
#[cfg(test)]
mod tests;
