//! Redundant closed contacts: reactions within their cones that hold the motion, where the
//! equations alone leave them open.
//!
//! The cone of a contact that sticks is spanned by its edges, `λ_N (1, ±μ_s)`, that of one that
//! slides is the half-line `λ_N (1, −σ μ)`. With the columns of the edges in A the multipliers y ≥
//! 0, and those of two-sided rows and the accelerations without a sign, are those of
//! `|A y − r| → min`, by the method of Lawson and Hanson (*Solving Least Squares Problems*, 1974,
//! chapter 23). Admissible ones exist where the least value is zero.

use std::collections::BTreeSet;

use nalgebra::{DMatrix, DVector};

use super::modes::{ContactMode, ModeChoice, ModeCondition};
use super::problem::{self, ActiveRows, BalancedProblem, Edge, RowEquations, Trial, Unit};
use crate::contact::trials::LcpError;
use crate::numerics::decomposition::svd;
use crate::numerics::zero::SOLVED;

/// Columns taken in at most, for each there is.
const CHANGES: usize = 10;

impl BalancedProblem<'_> {
    /// The motion of modes whose equations are singular, if reactions exist that meet the
    /// conditions on them.
    pub(super) fn admissible(
        &self,
        chosen: &[&ModeChoice],
        closed: &ActiveRows,
        equations: &RowEquations,
    ) -> Result<Option<Trial>, LcpError> {
        if self.units.iter().any(|unit| unit.given.is_some()) {
            // One with fewer contacts closed, or at the bounds of friction, has the same motion.
            return Ok(None);
        }
        let n = self.kkt.n;
        let (_, determined) = equations.least_norm(&equations.right, n).ok_or(LcpError::Singular)?;
        let (edges, signed): (Vec<Edge>, Vec<bool>) = self.edges(chosen, closed);
        let of_edges = closed.build_edge_matrix(&edges).ok_or(LcpError::Singular)?;
        let mut matrix =
            equations.matrix.columns(0, n).into_owned().resize_horizontally(n + edges.len(), 0.0);
        let columns = equations.matrix.columns(n, closed.rows.len());
        columns.mul_to(&of_edges, &mut matrix.columns_mut(n, edges.len()));
        let loads = edges.iter().zip(signed).map(|(edge, signed)| (n + edge[0].0, signed));
        let entries: Vec<(usize, bool)> = (0..n).map(|i| (i, false)).chain(loads).collect();
        let Some(y) = self.least_squares(&matrix, equations, &entries) else { return Ok(None) };
        if !self.kkt.are_met(equations, &matrix, &y) {
            return Ok(None);
        }
        let mut x = DVector::zeros(equations.index.len());
        x.rows_mut(0, n).copy_from(&y.rows(0, n));
        x.rows_mut(n, closed.rows.len()).copy_from(&(of_edges * y.rows(n, edges.len())));
        Ok(Some(Trial { unique: false, determined, ..self.trial(closed, &x) }))
    }

    /// y of least `|A y − r|` in each part of the system for itself, lest the rounding of one is
    /// what moves another; an entry of y belongs to a coordinate or row, and may be ≥ 0.
    fn least_squares(
        &self,
        a: &DMatrix<f64>,
        equations: &RowEquations,
        entries: &[(usize, bool)],
    ) -> Option<DVector<f64>> {
        let parts = &self.kkt.parts;
        let mut y = DVector::zeros(entries.len());
        for part in entries.iter().map(|(of, _)| parts[*of]).collect::<BTreeSet<_>>() {
            let columns: Vec<usize> = (0..entries.len()).filter(|&j| parts[entries[j].0] == part).collect();
            let rows = equations.index.iter().enumerate().filter(|(_, of)| parts[**of] == part);
            let rows: Vec<usize> = rows.map(|(i, _)| i).collect();
            let one_sided: Vec<bool> = columns.iter().map(|&j| entries[j].1).collect();
            let own = a.select_rows(&rows).select_columns(&columns);
            let found = least_squares(&own, &equations.right.select_rows(&rows), &one_sided)?;
            columns.iter().zip(found.iter()).for_each(|(&j, found)| y[j] = *found);
        }
        Some(y)
    }

    /// The edges of all multipliers with whether each has a sign.
    pub(super) fn edges(&self, chosen: &[&ModeChoice], closed: &ActiveRows) -> (Vec<Edge>, Vec<bool>) {
        let mut edges = Vec::new();
        let mut taken = Vec::new();
        for (unit, choice) in self.units.iter().zip(chosen) {
            if choice.mode == ContactMode::Open {
                continue;
            }
            taken.extend([Some(unit.normal), unit.tangent.filter(|_| choice.mode.sense().is_none())]);
            edges.extend(self.cone(unit, choice));
        }
        let other = closed.rows.iter().filter(|row| !taken.contains(&Some(**row)));
        edges.extend(other.map(|&row| (vec![(row, 1.0)], false)));
        edges.into_iter().unzip()
    }

    fn cone(&self, unit: &Unit, choice: &ModeChoice) -> Vec<(Edge, bool)> {
        let normal = (unit.normal, choice.mode.side());
        let Some(tangent) = unit.tangent.filter(|_| choice.mode.sense().is_none()) else {
            return vec![(vec![normal], choice.asks(ModeCondition::Presses))];
        };
        let share = unit.limit * self.kkt.ratio(unit.normal, tangent);
        let edge = |sign: f64| vec![normal, (tangent, sign * share)];
        let across = |sign: f64| vec![(tangent, sign)];
        match (choice.asks(ModeCondition::Below), choice.asks(ModeCondition::Above)) {
            (true, true) => vec![(edge(1.0), true), (edge(-1.0), true)],
            (true, false) => vec![(edge(1.0), false), (across(-1.0), true)],
            (false, true) => vec![(edge(-1.0), false), (across(1.0), true)],
            (false, false) => vec![(vec![normal], choice.asks(ModeCondition::Presses)), (across(1.0), false)],
        }
    }
}

/// y of least `|A y − r|` with some entries ≥ 0.
fn least_squares(a: &DMatrix<f64>, right: &DVector<f64>, one_sided: &[bool]) -> Option<DVector<f64>> {
    let columns = a.ncols();
    let mut y = DVector::zeros(columns);
    let mut passive: Vec<usize> = (0..columns).filter(|&j| !one_sided[j]).collect();
    let mut refused: Vec<usize> = Vec::new();
    for _ in 0..CHANGES * (columns + 1) {
        descend(a, right, one_sided, (&mut y, &mut passive))?;
        let rest = right - a * &y;
        let gain = |j: usize| {
            let size = a.column(j).norm() * right.norm();
            if size > 0.0 { a.column(j).dot(&rest) / size } else { 0.0 }
        };
        let others = (0..columns).filter(|j| !passive.contains(j) && !refused.contains(j));
        let Some(best) = others.max_by(|&i, &j| gain(i).total_cmp(&gain(j))) else { break };
        if gain(best) <= SOLVED {
            break;
        }
        passive.push(best);
        let trial = subset(a, right, &passive)?;
        if trial[passive.len() - 1] <= 0.0 {
            passive.pop();
            refused.push(best);
        } else {
            refused.clear();
        }
    }
    Some(y)
}

/// The least-squares solution with the passive columns, of which those whose entries would turn
/// negative on the way leave.
fn descend(
    a: &DMatrix<f64>,
    right: &DVector<f64>,
    one_sided: &[bool],
    (y, passive): (&mut DVector<f64>, &mut Vec<usize>),
) -> Option<()> {
    loop {
        let target = subset(a, right, passive)?;
        // How far on the way to the target each entry that turns negative vanishes.
        let turns = |(j, t): &(&usize, &f64)| one_sided[**j] && **t < 0.0;
        let steps = passive.iter().zip(target.iter()).filter(turns);
        let steps: Vec<(usize, f64)> = steps.map(|(&j, t)| (j, y[j] / (y[j] - t))).collect();
        let part = steps.iter().fold(1.0, |least: f64, (_, step)| least.min(*step));
        for (&j, t) in passive.iter().zip(target.iter()) {
            y[j] += part * (t - y[j]);
        }
        if steps.is_empty() {
            return Some(());
        }
        let leaving: Vec<usize> = steps.iter().filter(|(_, step)| *step <= part).map(|(j, _)| *j).collect();
        passive.retain(|j| !leaving.contains(j));
        leaving.into_iter().for_each(|j| y[j] = 0.0);
    }
}

/// In units of the columns, so that none is lost beside a longer one.
fn subset(a: &DMatrix<f64>, right: &DVector<f64>, columns: &[usize]) -> Option<DVector<f64>> {
    if columns.is_empty() {
        return Some(DVector::zeros(0));
    }
    let mut part = a.select_columns(columns);
    let lengths = part.column_iter().map(|column| column.norm());
    let units: Vec<f64> = lengths.map(|length| if length > 0.0 { length } else { 1.0 }).collect();
    part.column_iter_mut().zip(&units).for_each(|(mut column, unit)| column /= *unit);
    let y = problem::least_squares(&svd(part), right)?;
    Some(y.component_div(&DVector::from_vec(units)))
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::{descend, least_squares};

    /// A y = r is met best where no entry can be changed for the better: Aᵀ(A y − r) = 0, and ≥ 0
    /// where y = 0 has a sign.
    fn is_least(a: &DMatrix<f64>, right: &DVector<f64>, one_sided: &[bool]) -> Result<(), TestCaseError> {
        let y = least_squares(a, right, one_sided).expect("it comes to an end");
        let slope = a.tr_mul(&(a * &y - right));
        for (j, &signed) in one_sided.iter().enumerate() {
            let size = a.column(j).norm() * right.norm();
            let least = if signed && y[j] == 0.0 { f64::NEG_INFINITY } else { -1e-10 * size };
            prop_assert!(!signed || y[j] >= 0.0, "{y}");
            prop_assert!(-slope[j] <= 1e-10 * size && -slope[j] >= least, "{j}: {} of {size}", slope[j]);
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn no_entry_can_be_changed_for_the_better(
            entries in vec(-1.0..1.0, 48),
            sizes in vec(-2..2, 8),
            right in vec(-1.0..1.0, 6),
            (size, free) in (-9..9, 0..8usize),
        ) {
            let a = DMatrix::from_fn(6, 8, |i, j| entries[6 * j + i] * 10f64.powi(sizes[j]));
            let one_sided: Vec<bool> = (0..8).map(|j| j >= free).collect();
            is_least(&a, &(DVector::from_vec(right) * 10f64.powi(size)), &one_sided)?;
        }

        #[test]
        fn a_single_column_bears_what_it_can(column in vec(-1.0..1.0, 3), right in vec(-1.0..1.0, 3)) {
            is_least(&DMatrix::from_vec(3, 1, column), &DVector::from_vec(right), &[true])?;
        }
    }

    /// Two columns at an obtuse angle of which both entries are to turn negative: the one that
    /// vanishes first leaves, and the other one then need not. y₁ = 1 falls to −1 and vanishes on
    /// half of the way, y₂ falls to −½ from y₂ and vanishes at y₂/(y₂ + ½).
    #[test]
    fn the_entry_that_vanishes_first_leaves() {
        let (cosine, sine) = (-0.8, 0.6);
        let a = DMatrix::from_row_slice(2, 2, &[1.0, cosine, 0.0, sine]);
        let right = &a * DVector::from_row_slice(&[-1.0, -0.5]);
        // Alone the second column has −½ − c, the first one −1 − c/2.
        for (second, stays) in [(1.0, Some(1)), (0.3, None), (0.7, Some(1))] {
            let mut y = DVector::from_row_slice(&[1.0, second]);
            let mut passive = vec![0, 1];
            descend(&a, &right, &[true; 2], (&mut y, &mut passive)).unwrap();
            let expected = match stays {
                Some(_) => [0.0, -0.5 - cosine],
                None => [0.0, 0.0],
            };
            assert!((&y - DVector::from_row_slice(&expected)).amax() < 1e-14, "{second}: {y}");
            assert_eq!(passive, stays.into_iter().collect::<Vec<_>>(), "{second}");
        }
        // What has no sign stays, whatever its entry is.
        let (mut y, mut passive) = (DVector::from_row_slice(&[1.0, 1.0]), vec![0, 1]);
        descend(&a, &right, &[false; 2], (&mut y, &mut passive)).unwrap();
        assert!((&y - DVector::from_row_slice(&[-1.0, -0.5])).amax() < 1e-14 && passive.len() == 2, "{y}");
    }
}
