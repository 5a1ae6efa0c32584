//! Mobility: joints that depend on others at random configurations do so identically. Equal cranks
//! depend on each other only where their loops are closed, as they are in the figure.

use std::collections::BTreeMap;

use super::Kinematics;
use crate::algebra::{Series, Symbol};
use crate::system::{ParameterValues, System};

/// Rows are independent by rounding of a few dozen operations, far below what random entries
/// produce by chance.
const ROUNDING: f64 = 1e-9;
/// Rows of a figure that is drawn from rounded numbers are independent if they are by so much.
const ROUGH: f64 = 0.1;

/// Values of parameters and coordinates by symbol.
pub fn nominal_values(
    system: &System,
    numbers: &ParameterValues,
    coordinates: &[f64],
) -> BTreeMap<Symbol, f64> {
    let parameters = (0..system.parameters.len() + system.constants.len()).map(|i| {
        let symbol = Symbol::parameter(i);
        (symbol, numbers.evaluate(&Series::symbol(symbol)))
    });
    let coordinates = coordinates.iter().enumerate().map(|(i, &q)| (Symbol::coordinate(i), q));
    parameters.chain(coordinates).collect()
}

/// Indices of rows that depend on the rows before them by rounding.
pub(crate) fn dependent(rows: &[Vec<f64>]) -> Vec<usize> {
    dependent_within(rows, ROUNDING)
}

/// Indices of rows of which no more than a part is independent of the rows before them, by
/// Gram–Schmidt.
fn dependent_within(rows: &[Vec<f64>], part: f64) -> Vec<usize> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let mut found = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let size = norm(row);
        let mut rest = row.clone();
        for _ in 0..2 {
            for unit in &basis {
                let along: f64 = unit.iter().zip(&rest).map(|(a, b)| a * b).sum();
                rest.iter_mut().zip(unit).for_each(|(r, u)| *r -= along * u);
            }
        }
        let left = norm(&rest);
        if left <= part * size || size == 0.0 {
            found.push(i);
        } else {
            basis.push(rest.iter().map(|r| r / left).collect());
        }
    }
    found
}

fn norm(row: &[f64]) -> f64 {
    row.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn jacobian(equations: &[&Series], values: &BTreeMap<Symbol, f64>, n: usize) -> Vec<Vec<f64>> {
    let value = |symbol: Symbol| values.get(&symbol).copied().unwrap_or(0.0);
    equations
        .iter()
        .map(|g| (0..n).map(|i| g.derivative(Symbol::coordinate(i)).evaluate(&value)).collect())
        .collect()
}

/// Which of `equations` depend on those before them at every configuration. Where these hold all
/// coordinates, off the figure, any other depends on them, and that says nothing.
fn redundant(system: &System, equations: &[&Series], n: usize) -> Vec<usize> {
    let mut common: Option<Vec<usize>> = None;
    let Some(numbers) = system.samples.first() else { return Vec::new() };
    for sample in 1..=3 {
        let q: Vec<f64> = (0..n).map(|i| 0.3 + (1.7 * (i + 1) as f64 * sample as f64).sin()).collect();
        let rows = jacobian(equations, &nominal_values(system, numbers, &q), n);
        let found = dependent(&rows).into_iter().enumerate().filter(|(before, i)| i - before < n);
        let found: Vec<usize> = found.map(|(_, i)| i).collect();
        common = Some(match common {
            None => found,
            Some(known) => known.into_iter().filter(|i| found.contains(i)).collect(),
        });
    }
    common.unwrap_or_default()
}

/// Reports redundant joints and mechanisms that cannot move. What moves at some values of the
/// parameters is left to the start of a run, which knows them.
pub(super) fn check_mobility(system: &System, kinematics: &Kinematics) -> syn::Result<()> {
    let n = kinematics.coordinates.len();
    let equations: Vec<&Series> = kinematics.joints.iter().map(|j| &j.equation).collect();
    let mut errors = redundant(system, &equations, n).into_iter().map(|i| {
        let joint = &kinematics.joints[i];
        let text = format!("{} repeats what other joints hold already; remove it", joint.name);
        syn::Error::new(joint.span, text)
    });
    if let Some(mut all) = errors.next() {
        errors.for_each(|e| all.combine(e));
        return Err(all);
    }
    let holds_all = |numbers: &ParameterValues| {
        let values = nominal_values(system, numbers, &kinematics.nominal(system, numbers));
        let rows = jacobian(&equations, &values, n);
        rows.len() - dependent_within(&rows, ROUGH).len() >= n
    };
    if system.samples.iter().all(holds_all) && system.drives.iter().all(|drive| drive.switched) {
        let text = format!(
            "nothing can move: {n} coordinates and {n} independent constraints; remove a pin or a constraint"
        );
        return Err(syn::Error::new(system.ident.span(), text));
    }
    Ok(())
}
