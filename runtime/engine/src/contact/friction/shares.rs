//! Reactions that are not unique: of all within the cones of friction that hold the same motion, the shortest,
//!
//! ```text
//! ½ |λ|² → min,    Jᵀ λ = F,    λ ∈ K
//! ```
//!
//! with K the product of a contact's cone `|R| ≤ μ_s λ_N` while it sticks, its edge `R = −σ μ λ_N` while it slides, λ ≥ 0
//! of contacts without friction, and all of two-sided rows. As in [`least_norm`](crate::contact::least_norm) the dual has the
//! dimension of the motion alone: λ is the projection of J y on K, and `Jᵀ λ(y) = F` is solved by Newton's method.

use nalgebra::{DMatrix, DVector};

use super::decision::{FrictionSolution, Question};
use super::modes::Mode;
use crate::contact::closed_rows::ClosedRows;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::integration::phase_point::Numbers;
use crate::model::{ContactSet, Slip};
use crate::scales::slips;
use crate::system::System;

/// Newton steps at most; of what it does not reach by then, the reactions that were found are left.
const STEPS: usize = 100;
/// Residual of Jᵀ λ = F relative to F.
const SOLVED: f64 = 1e-13;
/// Halvings of a step.
const HALVINGS: usize = 40;

/// A factor of K that is not all of its space, with the places of its rows.
#[derive(Debug, Clone, Copy)]
enum Factor {
    Pressing(usize),
    Cone { normal: usize, tangent: usize, limit: f64 },
    Edge { normal: usize, tangent: usize, slope: f64 },
}

/// J of closed rows in natural coordinates and own units, and F.
struct Shares {
    jacobian: DMatrix<f64>,
    load: DVector<f64>,
    factors: Vec<Factor>,
}

/// The multipliers of all rows given some that hold the same motion with the contacts of a set closed, the shortest of those.
pub(crate) fn shortest_within_cones(
    system: &dyn System,
    state: &[f64],
    closed: &ContactSet,
    held: &[f64],
) -> Numbers {
    let layout = system.layout();
    let closed_rows = ClosedRows::of(system, state, closed);
    let slips = slips(system, state);
    let contacts = closed.iter().filter_map(|contact| Some((contact, closed_rows.place(contact)?)));
    let factor = |(contact, normal): (usize, usize)| {
        let friction = layout.contacts[contact].friction;
        let tangent =
            friction.and_then(|entry| Some((entry, closed_rows.place(layout.frictions[entry].row)?)));
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
    let ClosedRows { rows, jacobian } = closed_rows;
    let load = jacobian.tr_mul(&DVector::from_fn(rows.len(), |k, _| held[rows[k]]));
    let mut reactions = Numbers::from_slice(held);
    if let Some(shortest) = (Shares { jacobian, load, factors }).shortest() {
        rows.iter().zip(shortest.iter()).for_each(|(&row, &share)| reactions[row] = share);
    }
    reactions
}

impl EquilibratedKkt {
    /// λ of every row, the shortest of those that hold the motion of a solution; in impacts with what is given, those found.
    pub(crate) fn share_with_friction(&self, question: &Question, found: &FrictionSolution) -> DVector<f64> {
        let reactions = &found.solution.reactions;
        let given = question.contacts.iter().any(|contact| contact.given.is_some());
        if found.solution.unique || !found.determined || given {
            return reactions.clone();
        }
        let (rows, factors) = factors(question, found);
        let jacobian = self.rows_in_own_units(&rows);
        let load = jacobian.tr_mul(&DVector::from_fn(rows.len(), |k, _| reactions[rows[k]]));
        let mut shared = reactions.clone();
        if let Some(shortest) = (Shares { jacobian, load, factors }).shortest() {
            rows.iter().zip(shortest.iter()).for_each(|(&row, &share)| shared[row] = share);
        }
        shared
    }
}

/// The rows that bear, with tangents of contacts that slide, and K.
fn factors(question: &Question, found: &FrictionSolution) -> (Vec<usize>, Vec<Factor>) {
    let mut rows: Vec<usize> = Vec::new();
    let mut factors = Vec::new();
    let contacts = question.contacts.iter().zip(&found.modes);
    for (contact, mode) in contacts.filter(|(_, mode)| mode.is_closed()) {
        let (normal, tangent) = (rows.len(), rows.len() + 1);
        rows.extend([contact.normal, contact.tangent]);
        match mode {
            Mode::Slide(sense) => {
                factors.push(Factor::Edge { normal, tangent, slope: -sense.sign() * contact.mu });
            }
            _ => factors.push(Factor::Cone { normal, tangent, limit: contact.limit }),
        }
    }
    let others: Vec<usize> = found.solution.tight.iter().copied().filter(|row| !rows.contains(row)).collect();
    for row in others {
        let place = rows.len();
        rows.push(row);
        if question.rows.candidates.contains(&row) {
            factors.push(Factor::Pressing(place));
        }
    }
    (rows, factors)
}

impl Factor {
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
    fn shortest(&self) -> Option<DVector<f64>> {
        let size = self.load.norm();
        let mut y = step(&self.jacobian, &self.jacobian, &self.load)?;
        for _ in 0..STEPS {
            let (reactions, derivative) = self.reactions(&y);
            let rest = &self.load - self.jacobian.tr_mul(&reactions);
            if rest.norm() <= SOLVED * size {
                return Some(reactions);
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

    /// The longest of the halved steps that lowers ½ |λ|² − F·y; `slope` is what the whole one would gain.
    fn descend(&self, y: &DVector<f64>, step: &DVector<f64>, slope: f64) -> DVector<f64> {
        let value = |y: &DVector<f64>| 0.5 * self.reactions(y).0.norm_squared() - self.load.dot(y);
        let now = value(y);
        let mut tried = (0..HALVINGS).map(|k| 0.5f64.powi(k as i32)).map(|part| (part, y + step * part));
        let lower = tried.find(|(part, ahead)| value(ahead) <= now - 1e-4 * part * slope);
        lower.map_or_else(|| y + step, |(_, ahead)| ahead)
    }
}

/// Newton's step Jᵀ λ' Δy = r, of least norm where that is not unique.
fn step(jacobian: &DMatrix<f64>, derivative: &DMatrix<f64>, rest: &DVector<f64>) -> Option<DVector<f64>> {
    let svd = jacobian.tr_mul(derivative).svd(true, true);
    let cutoff = 64.0 * f64::EPSILON * svd.singular_values.amax();
    svd.solve(rest, cutoff).ok()
}
