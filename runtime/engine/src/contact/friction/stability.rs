//! Which closed contacts stiff springs can hold. With N = K δ for the compressions δ = −g of the
//! closed normals and K → ∞
//!
//! ```text
//! δ̈ = −W N − …,    W = J_N M̂⁻¹ (J_N − σ μ J_t)ᵀ
//! ```
//!
//! where M̂⁻¹ takes in the two-sided rows and the tangents of contacts that stick: an eigenvalue of
//! W with a real part that is not positive makes the compressions grow at once (Pfeiffer and
//! Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996, on Painlevé; equal stiffness of
//! all contacts). Of contacts that depend on each other only independent compressions count: W is
//! restricted to the range of J_N M̂⁻¹ J_Nᵀ.
//!
//! The diagonal entry of one sliding contact with all others kept as they are is what vanishes at
//! the border of Painlevé's region.

use std::collections::BTreeSet;

use nalgebra::{DMatrix, DVector};

use super::decision::Reason;
use super::modes::ContactMode;
use super::problem::{ActiveRows, BalancedProblem, Candidate};
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::context::slips;
use crate::model::ContactSet;
use crate::numerics::decomposition::{eigenvalues, symmetric_eigen};
use crate::numerics::zero::RANK;
use crate::system::System;

/// A sliding contact: its rows, and σ μ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sliding {
    pub(crate) normal: usize,
    pub(crate) tangent: usize,
    pub(crate) signed_mu: f64,
}

/// W_NN − σ μ W_Nt of a sliding contact while other rows stay closed and other contacts slide: by
/// how much its normal reaction opens it. At zero the reaction is infinite; where it is negative
/// the contact cannot be held. `None` where the accelerations are not determined.
pub(crate) fn painleve(
    mass: &DMatrix<f64>,
    jacobian: &DMatrix<f64>,
    contact: Sliding,
    closed: &[usize],
    others: &[Sliding],
) -> Option<f64> {
    let (force, bias) = (DVector::zeros(mass.nrows()), DVector::zeros(jacobian.nrows()));
    let kkt = EquilibratedKkt::new(mass, jacobian, (&force, &bias), (&force, &bias));
    let held = ActiveRows {
        rows: closed.iter().copied().chain(others.iter().map(|other| other.normal)).collect(),
        bends: others.iter().map(|it| (it.normal, it.tangent, -it.signed_mu)).collect(),
        loads: Vec::new(),
    };
    let a = kkt.response(&held, &kkt.bent_column(contact.normal, contact.tangent, -contact.signed_mu))?;
    let unit = kkt.scale[kkt.n + contact.normal];
    Some(kkt.opening(contact.normal, &a) / (unit * unit))
}

/// The least W_NN − σ μ W_Nt of the contacts that slide in a set, each relative to its W_NN. `None`
/// where none slides, or the accelerations are not determined.
pub(crate) fn least_hold(system: &dyn System, state: &[f64], set: &ContactSet) -> Option<f64> {
    holds(system, state, set).into_iter().map(|(_, hold)| hold).reduce(f64::min)
}

/// W_NN − σ μ W_Nt of each contact that slides in a set, relative to its W_NN.
pub(crate) fn holds(system: &dyn System, state: &[f64], set: &ContactSet) -> Vec<(usize, f64)> {
    let (layout, equations, slips) = (system.layout(), system.equations(state), slips(system, state));
    let (n, rows) = (layout.coordinates.len(), layout.rows());
    let mass = DMatrix::from_fn(n, n, |i, j| equations.mass(i)[j]);
    let jacobian = DMatrix::from_fn(rows, n, |i, j| equations.jacobian(i)[j]);
    let sliding: Vec<Sliding> = layout
        .sliding(set)
        .filter(|(_, friction)| !layout.contacts[friction.contact].is_hinge())
        .map(|(entry, friction)| Sliding {
            normal: friction.contact,
            tangent: friction.row,
            signed_mu: set.sense(friction.contact) as f64 * slips[entry].kinetic,
        })
        .collect();
    let slides = |row: usize| sliding.iter().any(|it| it.normal == row);
    let closed: Vec<usize> = (0..rows).filter(|&row| layout.is_closed(row, set) && !slides(row)).collect();
    let hold = |it: &Sliding| {
        let others: Vec<Sliding> = sliding.iter().copied().filter(|other| other != it).collect();
        let with = |it: Sliding| painleve(&mass, &jacobian, it, &closed, &others);
        Some((it.normal, with(*it)? / with(Sliding { signed_mu: 0.0, ..*it })?))
    };
    sliding.iter().filter_map(hold).collect()
}

impl EquilibratedKkt {
    /// The balanced column of a sliding contact's normal reaction.
    pub(super) fn bent_column(&self, normal: usize, tangent: usize, factor: f64) -> DVector<f64> {
        self.column_of(normal) + self.column_of(tangent) * (factor * self.ratio(normal, tangent))
    }

    /// The balanced Jᵀ of a row.
    pub(super) fn column_of(&self, row: usize) -> DVector<f64> {
        self.matrix.view((self.n + row, 0), (1, self.n)).transpose().column(0).into_owned()
    }

    /// What a generalised force alone accelerates, with some rows closed.
    pub(super) fn response(&self, held: &ActiveRows, force: &DVector<f64>) -> Option<DVector<f64>> {
        let equations = self.equations(held).ok()?;
        let mut right = DVector::zeros(equations.index.len());
        right.rows_mut(0, self.n).copy_from(force);
        let x = match equations.solve_for(&right) {
            Some(x) => x,
            None => equations.least_norm(&right, self.n).filter(|(_, determined)| *determined)?.0,
        };
        Some(x.rows(0, self.n).into_owned())
    }
}

impl BalancedProblem<'_> {
    /// The solution that is taken.
    pub(super) fn choose(&self, found: &[Candidate]) -> Option<(usize, Reason)> {
        let modes: Vec<Vec<ContactMode>> =
            found.iter().map(|candidate| self.modes(&candidate.chosen)).collect();
        let mut left: Vec<usize> = (0..found.len()).collect();
        let stable: Vec<usize> = left.iter().copied().filter(|&k| self.is_stable(&found[k].acting)).collect();
        let mut reason = if stable.is_empty() { Reason::Unstable } else { Reason::Only };
        let mut narrow = |kept: Vec<usize>, why: Reason| {
            if kept.len() < left.len() && reason != Reason::Unstable {
                reason = why;
            }
            left = kept;
            left.clone()
        };
        let kept = if stable.is_empty() { (0..found.len()).collect() } else { stable };
        let kept = narrow(kept, Reason::Stable);
        let kept = narrow(least(&kept, |k| closed(&modes[k])), Reason::LiftOff);
        let kept = narrow(least(&kept, |k| modes[k].len() - sticking(&modes[k])), Reason::Sticks);
        narrow(kept.into_iter().take(1).collect(), Reason::First);
        left.first().map(|&k| (k, reason))
    }

    /// Whether stiff springs hold the closed contacts, those of each part of the system for
    /// themselves.
    pub(super) fn is_stable(&self, modes: &[ContactMode]) -> bool {
        if !modes.iter().any(|mode| mode.is_closed() && mode.sense().is_some()) {
            return true;
        }
        let units = self.units.iter().zip(modes).filter(|(_, mode)| mode.is_closed());
        let normals: Vec<usize> = units.map(|(unit, _)| unit.normal).collect();
        let part = |row: usize| self.kkt.parts[self.kkt.n + row];
        let parts: BTreeSet<usize> = normals.iter().map(|&row| part(row)).collect();
        parts.into_iter().all(|own| {
            let own: Vec<usize> = normals.iter().copied().filter(|&row| part(row) == own).collect();
            self.compliance(modes, &normals, &own).is_some_and(|w| {
                let eigenvalues = eigenvalues(w);
                let largest = eigenvalues.iter().fold(0.0, |most: f64, z| most.max(z.norm()));
                eigenvalues.iter().all(|z| z.re > RANK * largest)
            })
        })
    }

    /// W of some closed normals in own units on independent compressions, while all closed ones
    /// give way.
    fn compliance(
        &self,
        modes: &[ContactMode],
        closed_normals: &[usize],
        normals: &[usize],
    ) -> Option<DMatrix<f64>> {
        let kkt = self.kkt;
        let closed = self.closed(modes);
        let held = closed.rows.iter().copied().filter(|row| !closed_normals.contains(row));
        let held = ActiveRows { rows: held.collect(), ..ActiveRows::default() };
        let bend = |row: usize| closed.bends.iter().find(|(normal, ..)| *normal == row);
        let respond = |column: &dyn Fn(usize) -> DVector<f64>| {
            let columns: Vec<_> = normals
                .iter()
                .map(|&row| kkt.response(&held, &column(row)).map(|a| a / kkt.scale[kkt.n + row]))
                .collect::<Option<_>>()?;
            let entry = |i: usize, j: usize| self.acceleration(normals[i], &columns[j]);
            Some(DMatrix::from_fn(normals.len(), normals.len(), entry))
        };
        let smooth = respond(&|row| kkt.column_of(row))?;
        let sliding = respond(&|row| match bend(row) {
            Some(&(normal, tangent, factor)) => kkt.bent_column(normal, tangent, factor),
            None => kkt.column_of(row),
        })?;
        let range = symmetric_eigen(&smooth + smooth.transpose());
        let largest = range.eigenvalues.amax();
        let places: Vec<usize> =
            (0..normals.len()).filter(|&k| range.eigenvalues[k] > RANK * largest).collect();
        let basis = range.eigenvectors.select_columns(&places);
        Some(basis.transpose() * sliding * basis)
    }

    /// J a of a row in its own unit.
    pub(super) fn acceleration(&self, row: usize, a: &DVector<f64>) -> f64 {
        self.kkt.column_of(row).dot(a) / self.kkt.scale[self.kkt.n + row]
    }
}

fn closed(modes: &[ContactMode]) -> usize {
    modes.iter().filter(|mode| mode.is_closed()).count()
}

fn sticking(modes: &[ContactMode]) -> usize {
    modes.iter().filter(|mode| mode.holds_tangent()).count()
}

/// The places where a number is least.
fn least(places: &[usize], number: impl Fn(usize) -> usize) -> Vec<usize> {
    let smallest = places.iter().map(|&k| number(k)).min();
    places.iter().copied().filter(|&k| Some(number(k)) == smallest).collect()
}

#[cfg(test)]
mod tests;
