//! The closed rows of J at a state, in natural coordinates, and the reactions that move nothing.

use liftoff_core::kernel::lever;
use nalgebra::DMatrix;

use crate::model::{ContactSet, Friction, Layout};
use crate::numerics::decomposition::{parts, range};
use crate::numerics::zero::MARGIN;
use crate::system::System;

/// The rows of closed contacts, with the tangents of those that slide, and of joints.
pub(super) struct ClosedRows {
    /// Their places among all rows.
    pub(super) rows: Vec<usize>,
    /// J in natural coordinates and own units of the rows.
    pub(super) jacobian: DMatrix<f64>,
    /// The length at which the multiplier of each row that is a couple is compared with forces; one
    /// of a force.
    pub(super) levers: Vec<f64>,
}

/// Those of rows, given entries of J by row and coordinate, and those of the diagonal of M.
pub(super) fn levers(
    layout: &Layout,
    rows: &[usize],
    entry: impl Fn(usize, usize) -> f64,
    mass: impl Fn(usize) -> f64,
) -> Vec<f64> {
    let lever = lever(layout, rows, entry, mass);
    rows.iter().map(|&row| if layout.is_turned(row) { lever } else { 1.0 }).collect()
}

impl ClosedRows {
    pub(super) fn compute(system: &dyn System, state: &[f64], closed: &ContactSet) -> Self {
        let (layout, equations) = (system.layout(), system.equations(state));
        let slides = |row: usize| layout.sliding(closed).any(|(_, friction)| friction.row == row);
        let acts = |row: &usize| layout.is_closed(*row, closed) || slides(*row);
        let rows: Vec<usize> = (0..layout.rows()).filter(acts).collect();
        let unit = |j: usize| {
            let inertia = equations.mass(j)[j];
            if inertia > 0.0 { inertia.sqrt() } else { 1.0 }
        };
        let n = layout.coordinates.len();
        let jacobian = DMatrix::from_fn(rows.len(), n, |k, j| equations.jacobian(rows[k])[j] / unit(j));
        let levers = levers(layout, &rows, |row, j| equations.jacobian(row)[j], |j| equations.mass(j)[j]);
        Self { rows, jacobian, levers }
    }

    /// The rows that are connected, by coordinates that they share, with some for which this holds.
    pub(super) fn connected_with(&self, is_asked: impl Fn(usize) -> bool) -> Self {
        let entries = self.jacobian.abs();
        let part = parts(&(&entries * entries.transpose()));
        let asked: Vec<usize> =
            (0..part.len()).filter(|&k| is_asked(self.rows[k])).map(|k| part[k]).collect();
        let kept: Vec<usize> = (0..part.len()).filter(|&k| asked.contains(&part[k])).collect();
        Self {
            rows: kept.iter().map(|&k| self.rows[k]).collect(),
            jacobian: self.jacobian.select_rows(&kept),
            levers: kept.iter().map(|&k| self.levers[k]).collect(),
        }
    }

    /// The place of a row of the layout among the closed ones.
    pub(super) fn find_index(&self, row: usize) -> Option<usize> {
        self.rows.iter().position(|&other| other == row)
    }

    /// Adds the friction of a contact that slides to the row of its normal, `J_N − σ μ J_t`, and
    /// takes that of its tangent out.
    pub(super) fn bend(&mut self, friction: Friction, signed_mu: f64) {
        if let (Some(normal), Some(tangent)) =
            (self.find_index(friction.contact), self.find_index(friction.row))
        {
            let bent = self.jacobian.row(normal) - self.jacobian.row(tangent) * signed_mu;
            self.jacobian.set_row(normal, &bent);
            self.jacobian.row_mut(tangent).fill(0.0);
        }
    }

    /// Which rows have a part in reactions λ with Jᵀ λ = 0: what they bear is not determined by the
    /// motion.
    pub(super) fn undetermined(&self) -> Vec<bool> {
        let determined = range(&self.jacobian);
        let is_zero = |row: usize| self.jacobian.row(row).amax() == 0.0;
        let is_free = |row: usize| 1.0 - determined.row(row).norm_squared() > MARGIN * MARGIN;
        (0..self.rows.len()).map(|row| !is_zero(row) && is_free(row)).collect()
    }
}
