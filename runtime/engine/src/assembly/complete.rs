//! Coordinates that a pose leaves open: g(q) = 0 over the joints and the contacts that touch in the
//! nominal figure, on the path of the given coordinates from their nominal values, so that the
//! branch is kept. Contacts that the given coordinates contradict are dropped, as few as possible.

use core::f64::consts::TAU;

use nalgebra::DVector;

use super::fold::settle_on_fold;
use super::path::{AssemblyPath, steps};
use super::problem::AssemblyProblem;
use super::{largest, touches, worst};
use crate::assembly::StartError;
use crate::contact::ActiveRows;
use crate::context::CLOSED;
use crate::model::ContactSet;
use crate::numerics::decomposition::svd;

/// Contacts of the nominal figure touch within this, relative to the natural length.
const NOMINAL: f64 = 1e-9;
/// How near to its contacts a step ends where the nominal figure does not determine a path.
const NEAR: f64 = 1e-4;
const ITERATIONS: usize = 40;

/// All coordinates, and the contacts that they close.
pub(super) fn positions(
    assembly: &AssemblyProblem<'_>,
    given: &[Option<f64>],
) -> Result<(Vec<f64>, ContactSet), StartError> {
    let nominal = &assembly.context.model.nominal;
    let assumed = within(assembly, nominal, [NOMINAL; 2]);
    let assumed = assumed.difference(assembly.absent(nominal).intersection(assembly.layout().drives()));
    let known = with_driven(assembly, given);
    let found = largest(assumed, |set| {
        let q = reach(assembly, &known, set)?;
        let absent = assembly.absent(&q);
        if assembly.refuse_penetration(&q, absent).is_err() {
            return Err(ContactSet::EMPTY);
        }
        // A contact by which the pose was completed is refused later if its bar does not reach it.
        let completed = if given.iter().all(Option::is_some) { ContactSet::EMPTY } else { set };
        let beyond = absent.difference(completed);
        let closed = within(assembly, &q, [assembly.deepest, CLOSED]).difference(beyond);
        let idle = absent.intersection(assembly.layout().drives());
        let closed = closed.difference(idle).union(assembly.layout().guides());
        Ok((q, closed))
    });
    found.ok_or_else(|| diagnose(assembly, given))
}

/// What is given with the coordinates that drives prescribe: such a row is linear in one of them.
/// The others follow on their path, not from where the nominal figure is, which may be singular.
fn with_driven(assembly: &AssemblyProblem<'_>, given: &[Option<f64>]) -> Vec<Option<f64>> {
    let (layout, nominal) = (assembly.layout(), &assembly.context.model.nominal);
    let (mut known, rows) = (given.to_vec(), assembly.rows(nominal));
    let drives = layout.joints.iter().enumerate().filter(|(_, joint)| joint.is_drive());
    for row in drives.map(|(joint, _)| layout.contacts.len() + joint) {
        let is_closed = |q: &[f64], gap: f64| gap.abs() <= assembly.closed_below(q, row) * assembly.unit(row);
        let unknowns: Vec<usize> = (0..nominal.len()).filter(|&i| rows.jacobian(row)[i] != 0.0).collect();
        if let [i] = unknowns[..]
            && known[i].is_none()
            && !is_closed(nominal, rows.gap()[row])
        {
            let mut moved = nominal.clone();
            moved[i] -= rows.gap()[row] / rows.jacobian(row)[i];
            known[i] = Some(moved[i]).filter(|_| is_closed(&moved, assembly.rows(&moved).gap()[row]));
        }
    }
    known
}

/// Contacts penetrated and open by no more than so many natural lengths.
fn within(assembly: &AssemblyProblem<'_>, q: &[f64], range: [f64; 2]) -> ContactSet {
    let rows = assembly.rows(q);
    let contacts = 0..assembly.layout().contacts.len();
    contacts.filter(|&i| touches(assembly.context, &rows, (i, q), range)).collect()
}

/// What is wrong with the pose even if no contact is assumed closed.
fn diagnose(assembly: &AssemblyProblem<'_>, given: &[Option<f64>]) -> StartError {
    let reached = completed(assembly, given, ContactSet::EMPTY);
    let is_reached = reached.is_some();
    let mut q = reached.unwrap_or_else(|| with_given(given, &assembly.context.model.nominal));
    let closed = assembly.closed(ContactSet::EMPTY);
    approach(assembly, (&closed, &left_open(assembly, given).0), &mut q);
    let rows = assembly.rows(&q);
    let gap = rows.gap();
    let missed = |row: usize| gap[row].abs() / assembly.unit(row);
    let worst = closed.iter().copied().max_by(|&a, &b| missed(a).total_cmp(&missed(b)));
    match (worst, assembly.refuse_penetration(&q, assembly.absent(&q))) {
        (Some(row), _) if missed(row) > assembly.closed_below(&q, row) => {
            // Of a pin or a hinge, which has a row for each axis, the distance.
            let place = |row: usize| {
                let name = assembly.joint(row);
                let place = [" (x)", " (y)"].iter().find_map(|axis| name.strip_suffix(axis));
                place.unwrap_or(&name).to_owned()
            };
            let joint = place(row);
            let there = closed.iter().filter(|&&row| place(row) == joint);
            let gaps: Vec<f64> = there.map(|&row| gap[row]).collect();
            let gap = if let [gap] = gaps[..] { gap } else { DVector::from(gaps).norm() };
            StartError::Broken { joint, gap }
        }
        _ if !is_reached => {
            let coordinates = assembly.layout().coordinates.iter().zip(given);
            let given = coordinates.filter(|(_, given)| given.is_some()).map(|(of, _)| of.name);
            StartError::Unreached { given: given.collect::<Vec<_>>().join(", ") }
        }
        (_, Err(penetration)) => penetration,
        (row, Ok(())) => StartError::Broken {
            joint: row.map_or_else(|| "the pose".to_owned(), |row| assembly.joint(row)),
            gap: row.map_or(f64::NAN, |row| gap[row]),
        },
    }
}

/// The completed pose, if the rows of `set` are satisfied there, or the contacts in the way.
fn reach(
    assembly: &AssemblyProblem<'_>,
    given: &[Option<f64>],
    set: ContactSet,
) -> Result<Vec<f64>, ContactSet> {
    let q = completed(assembly, given, set).ok_or(set)?;
    let rows = assembly.rows(&q);
    let missed = |row: usize| rows.gap()[row].abs() / assembly.unit(row) - assembly.closed_below(&q, row);
    let all = assembly.closed(set).into_iter().all(|row| missed(row) <= 0.0);
    if all { Ok(q) } else { Err(worst(set, missed, 0.0)) }
}

/// A position with what is given.
fn with_given(given: &[Option<f64>], q: &[f64]) -> Vec<f64> {
    given.iter().zip(q).map(|(given, q)| given.unwrap_or(*q)).collect()
}

/// The pose with the rows of `set` as nearly closed as they can be, if a path leads there.
fn completed(assembly: &AssemblyProblem<'_>, given: &[Option<f64>], set: ContactSet) -> Option<Vec<f64>> {
    let nominal = &assembly.context.model.nominal;
    let (open, unit) = left_open(assembly, given);
    let closed = assembly.closed(set);
    let at = |q: &[f64]| with_given(given, q);
    if open.is_empty() || closed.is_empty() {
        return Some(at(nominal));
    }
    let ways = ways(assembly, given);
    let unknown = (&closed[..], &open[..]);
    let mut q = nominal.clone();
    nearest(assembly, unknown, f64::EPSILON, &mut q);
    if ways[0].iter().any(|by| *by != 0.0) {
        let end = |path: AssemblyPath<'_>| ways.iter().find_map(|moves| path.end(moves)).map(|q| at(&q));
        q = match AssemblyPath::from(q.clone(), assembly, unknown) {
            Some(path) => end(path)?,
            // Of more rows than are needed those that are independent lead the way.
            None => AssemblyPath::from(q.clone(), assembly, (&independent(assembly, &closed, &q), &open))
                .and_then(end)
                .filter(|q| assembly.gaps(q, &closed).amax() <= NEAR)
                .unwrap_or_else(|| at(&stepwise(assembly, &ways[0], unknown))),
        };
        nearest(assembly, unknown, f64::EPSILON, &mut q);
    }
    settle_on_fold(assembly, unknown, &unit, &mut q);
    Some(q)
}

/// Of rows those that do not depend on the rows before them.
fn independent(assembly: &AssemblyProblem<'_>, closed: &[usize], q: &[f64]) -> Vec<usize> {
    let all: Vec<usize> = (0..q.len()).collect();
    let jacobian = assembly.jacobian(q, (closed, &all));
    let mut active = ActiveRows::default();
    for (row, entries) in closed.iter().zip(jacobian.row_iter()) {
        active.push(*row, &entries.transpose().normalize());
    }
    active.rows
}

/// By how much the given coordinates move from their nominal values: as they are given, and where
/// no path leads there, angles to the same position on the shorter way, and on the other.
fn ways(assembly: &AssemblyProblem<'_>, given: &[Option<f64>]) -> Vec<Vec<f64>> {
    let coordinates = assembly.layout().coordinates.iter();
    let moves = given.iter().zip(&assembly.context.model.nominal).zip(coordinates);
    let moves = moves.map(|((given, from), of)| (given.map_or(0.0, |to| to - from), of.is_angle));
    let turned = |turn: fn(f64) -> f64| -> Vec<f64> {
        moves.clone().map(|(by, is_angle)| if is_angle { turn(by) } else { by }).collect()
    };
    let straight = turned(|by| by);
    let shorter = turned(|by| by - TAU * (by / TAU).round());
    let longer = turned(|by| {
        let shorter = by - TAU * (by / TAU).round();
        shorter - TAU.copysign(shorter)
    });
    let mut ways = vec![straight, shorter, longer];
    ways.dedup();
    ways
}

/// The coordinates that are not given, and their units.
fn left_open(assembly: &AssemblyProblem<'_>, given: &[Option<f64>]) -> (Vec<usize>, Vec<f64>) {
    let (layout, scales) = (assembly.layout(), &assembly.context.scales);
    let free = (0..given.len()).filter(|&i| given[i].is_none());
    free.map(|i| (i, scales.coordinate(&layout.coordinates[i]))).unzip()
}

/// Moves the coordinates left open to where the squares of the gaps sum up to the least (Marquardt,
/// *An algorithm for least-squares estimation of nonlinear parameters*, J. SIAM 11, 1963).
fn approach(assembly: &AssemblyProblem<'_>, (closed, open): (&[usize], &[usize]), q: &mut Vec<f64>) {
    let (mut damping, mut gap) = (1.0, assembly.gaps(q, closed));
    for _ in 0..4 * ITERATIONS {
        let jacobian = assembly.jacobian(q, (closed, open));
        let mut normal = jacobian.tr_mul(&jacobian);
        (0..open.len()).for_each(|k| normal[(k, k)] += damping);
        let Some(change) = normal.cholesky().map(|normal| normal.solve(&jacobian.tr_mul(&gap))) else {
            return;
        };
        let mut moved = q.clone();
        for (k, &i) in open.iter().enumerate() {
            moved[i] -= change[k] * assembly.context.scales.coordinate(&assembly.layout().coordinates[i]);
        }
        let after = assembly.gaps(&moved, closed);
        if after.norm() < gap.norm() {
            (*q, gap, damping) = (moved, after, 0.1 * damping);
        } else if damping < 1.0 / f64::EPSILON {
            damping *= 10.0;
        } else {
            return;
        }
    }
}

/// The position behind moves of the given coordinates, where rows are more than coordinates left
/// open, or not independent.
fn stepwise(assembly: &AssemblyProblem<'_>, moves: &[f64], unknown: (&[usize], &[usize])) -> Vec<f64> {
    let mut q = assembly.context.model.nominal.clone();
    let steps = steps(assembly, moves);
    for _ in 0..steps {
        q.iter_mut().zip(moves).for_each(|(q, by)| *q += by / steps as f64);
        nearest(assembly, unknown, NEAR, &mut q);
    }
    q
}

/// Gauss–Newton on the open coordinates to gaps of so many natural lengths; least-norm where they
/// are not determined.
fn nearest(assembly: &AssemblyProblem<'_>, (closed, open): (&[usize], &[usize]), near: f64, q: &mut [f64]) {
    let scales = &assembly.context.scales;
    let unit = |k: usize| scales.coordinate(&assembly.layout().coordinates[open[k]]);
    for _ in 0..ITERATIONS {
        let gap = assembly.gaps(q, closed);
        if gap.amax() <= near {
            return;
        }
        let jacobian = assembly.jacobian(q, (closed, open));
        // A singular value below this is a branch point, as sin α = 1; there the direction stays as
        // it is.
        let cutoff = 1e-13 * jacobian.amax();
        let Ok(change) = svd(jacobian).solve(&gap, cutoff) else { return };
        if change.iter().any(|x| !x.is_finite()) {
            return;
        }
        for (k, &i) in open.iter().enumerate() {
            q[i] -= change[k].clamp(-0.5, 0.5) * unit(k);
        }
    }
}
