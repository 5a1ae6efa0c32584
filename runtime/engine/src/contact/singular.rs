//! Where the mass matrix does not determine the accelerations: which coordinates move no mass, and
//! what has none.

use nalgebra::{Cholesky, DMatrix};

use super::equations::SeriesEquations;
use super::equilibrated_kkt::EquilibratedKkt;
use super::{ContactError, labels};
use crate::model::{ContactSet, MeasureKind};
use crate::numerics::zero::MARGIN;
use crate::system::{Model, System};

/// The error that names a state where the accelerations with these contacts closed are all but
/// undetermined.
pub(crate) fn refuse_singular(model: &Model, state: &[f64], closed: ContactSet) -> Result<(), ContactError> {
    let equations = SeriesEquations::along(model, state, &[]);
    if !equations.are_finite() {
        return Err(ContactError::NotFinite);
    }
    match &undetermined(model, &equations, closed)[..] {
        [] => Ok(()),
        _ => Err(singular(model, state, closed)),
    }
}

/// The error of accelerations that are not determined, with what moves without a mass.
pub(crate) fn singular(model: &Model, state: &[f64], closed: ContactSet) -> ContactError {
    let layout = model.layout();
    let equations = SeriesEquations::along(model, state, &[]);
    let free = if equations.are_finite() { undetermined(model, &equations, closed) } else { Vec::new() };
    let massless = model.measures.iter().filter(|of| of.kind == MeasureKind::Mass && of.value == 0.0);
    ContactError::Singular {
        contacts: labels(layout, closed),
        coordinates: free.into_iter().map(|i| layout.coordinates[i].name.to_owned()).collect(),
        massless: massless.map(|of| of.of.to_owned()).collect(),
    }
}

/// Whether M alone determines the accelerations well, whatever is closed: cheaper than to ask for a
/// set.
pub(crate) fn are_determined(system: &dyn System, state: &[f64]) -> bool {
    let equations = system.equations(state);
    let n = equations.force().len();
    let inertia = |i: usize| equations.mass(i)[i].sqrt();
    let balanced = DMatrix::from_fn(n, n, |i, j| equations.mass(i)[j] / (inertia(i) * inertia(j)));
    // The least eigenvalue of a matrix with a diagonal of ones is no less than det M/e.
    Cholesky::new(balanced).is_some_and(|factor| factor.determinant() > MARGIN)
}

/// The coordinates whose accelerations are all but undetermined with these contacts closed.
fn undetermined(model: &Model, equations: &SeriesEquations, closed: ContactSet) -> Vec<usize> {
    let layout = model.layout();
    let rows: Vec<usize> = (0..layout.rows()).filter(|&row| layout.is_closed(row, &closed)).collect();
    let (force, bias) = (&equations.force[0], &equations.bias[0]);
    let (mass, jacobian) = (&equations.mass[0], &equations.jacobian[0]);
    let kkt = EquilibratedKkt::new(mass, jacobian, (force, bias), (&force.abs(), &bias.abs()));
    kkt.with_layout(layout).undetermined(&rows)
}

#[cfg(test)]
mod tests;
