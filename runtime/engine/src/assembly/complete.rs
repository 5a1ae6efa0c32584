//! Coordinates that a pose leaves open: g(q) = 0 over the joints and the contacts that touch in the nominal figure, by
//! Gauss–Newton along a straight path of the given coordinates from their nominal values, so that the branch is kept.
//! Contacts that the given coordinates contradict are dropped, as few as possible.

use nalgebra::{DMatrix, DVector};

use super::fold::settle_on_fold;
use super::problem::AssemblyProblem;
use super::{CLOSED, largest, worst};
use crate::decomposition::svd;
use crate::error::StartError;
use crate::model::ContactSet;

/// Contacts of the nominal figure touch within this, relative to the natural length.
const NOMINAL: f64 = 1e-9;
/// The most steps along the path, each of no more than 11°, or a fifth of the natural length, where so many suffice.
const PATH: usize = 16;
const STEP: f64 = core::f64::consts::PI / PATH as f64;
/// How near to its contacts the path is followed before its end.
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
    let found = largest(assumed, |set| {
        let q = reach(assembly, given, set)?;
        let penetrates = assembly.refuse_penetration(&assembly.rows(&q).gap, assembly.absent(&q)).is_err();
        if penetrates {
            return Err(ContactSet::EMPTY);
        }
        // A contact by which the pose was completed is refused later if its bar does not reach it.
        let completed = if given.iter().all(Option::is_some) { ContactSet::EMPTY } else { set };
        let beyond = assembly.absent(&q).difference(completed);
        let closed = within(assembly, &q, [assembly.deepest, CLOSED]).difference(beyond);
        let idle = assembly.absent(&q).intersection(assembly.layout().drives());
        let closed = closed.difference(idle).union(assembly.layout().guides());
        Ok((q, closed))
    });
    found.ok_or_else(|| diagnose(assembly, given))
}

/// Contacts penetrated and open by no more than so many natural lengths.
fn within(assembly: &AssemblyProblem<'_>, q: &[f64], [deep, high]: [f64; 2]) -> ContactSet {
    let gap = assembly.rows(q).gap;
    let touches = |i: &usize| (-deep..=high).contains(&(gap[*i] / assembly.unit(*i)));
    (0..assembly.layout().contacts.len()).filter(touches).collect()
}

/// What is wrong with the pose even if no contact is assumed closed.
fn diagnose(assembly: &AssemblyProblem<'_>, given: &[Option<f64>]) -> StartError {
    let q = homotopy(assembly, given, ContactSet::EMPTY);
    let gap = assembly.rows(&q).gap;
    let missed = |row: usize| gap[row].abs() / assembly.unit(row);
    let worst =
        assembly.closed(ContactSet::EMPTY).into_iter().max_by(|&a, &b| missed(a).total_cmp(&missed(b)));
    match (worst, assembly.refuse_penetration(&gap, assembly.absent(&q))) {
        (Some(row), _) if missed(row) > CLOSED => {
            StartError::Broken { joint: assembly.joint(row), gap: gap[row] }
        }
        (_, Err(penetration)) => penetration,
        (row, Ok(())) => StartError::Broken {
            joint: row.map_or_else(|| "the pose".to_owned(), |row| assembly.joint(row)),
            gap: row.map_or(f64::NAN, |row| gap[row]),
        },
    }
}

/// The end of the path, if the rows of `set` are satisfied there, or the contacts in the way.
fn reach(
    assembly: &AssemblyProblem<'_>,
    given: &[Option<f64>],
    set: ContactSet,
) -> Result<Vec<f64>, ContactSet> {
    let q = homotopy(assembly, given, set);
    let gap = assembly.rows(&q).gap;
    let missed = |row: usize| gap[row].abs() / assembly.unit(row);
    let all = assembly.closed(set).into_iter().all(|row| missed(row) <= CLOSED);
    if all { Ok(q) } else { Err(worst(set, missed, CLOSED)) }
}

fn homotopy(assembly: &AssemblyProblem<'_>, given: &[Option<f64>], set: ContactSet) -> Vec<f64> {
    let nominal = &assembly.context.model.nominal;
    let mut q = nominal.to_vec();
    let steps = path(assembly, given);
    for step in 1..=steps {
        let fraction = step as f64 / steps as f64;
        for (i, value) in given.iter().enumerate() {
            if let Some(value) = value {
                let from = nominal[i];
                q[i] = if step == steps { *value } else { from + fraction * (value - from) };
            }
        }
        gauss_newton(assembly, given, set, if step == steps { f64::EPSILON } else { NEAR }, &mut q);
    }
    let (free, unit) = left_open(assembly, given);
    let closed = assembly.closed(set);
    if !free.is_empty() && !closed.is_empty() {
        settle_on_fold(assembly, (&closed, &free), &unit, &mut q);
    }
    q
}

/// Steps from the nominal values of the given coordinates to what they are to be.
fn path(assembly: &AssemblyProblem<'_>, given: &[Option<f64>]) -> usize {
    let (coordinates, scales) = (assembly.layout().coordinates, &assembly.context.scales);
    let moves = given.iter().zip(&assembly.context.model.nominal).zip(coordinates);
    let farthest = moves.fold(0.0, |most: f64, ((given, from), coordinate)| {
        given.map_or(most, |given| most.max((given - from).abs() / scales.coordinate(coordinate)))
    });
    (farthest / STEP).ceil().clamp(1.0, PATH as f64) as usize
}

/// The coordinates that are not given, and their units.
fn left_open(assembly: &AssemblyProblem<'_>, given: &[Option<f64>]) -> (Vec<usize>, Vec<f64>) {
    let (layout, scales) = (assembly.layout(), &assembly.context.scales);
    let free = (0..given.len()).filter(|&i| given[i].is_none());
    free.map(|i| (i, scales.coordinate(&layout.coordinates[i]))).unzip()
}

/// Gauss–Newton on the free coordinates to gaps of so many natural lengths; least-norm where they are not determined.
fn gauss_newton(
    assembly: &AssemblyProblem<'_>,
    given: &[Option<f64>],
    set: ContactSet,
    near: f64,
    q: &mut [f64],
) {
    let (free, unit) = left_open(assembly, given);
    let closed = assembly.closed(set);
    if free.is_empty() || closed.is_empty() {
        return;
    }
    for _ in 0..ITERATIONS {
        let rows = assembly.rows(q);
        let gap = DVector::from_fn(closed.len(), |i, _| rows.gap[closed[i]] / assembly.unit(closed[i]));
        if gap.amax() <= near {
            return;
        }
        let jacobian = DMatrix::from_fn(closed.len(), free.len(), |i, k| {
            rows.jacobian[(closed[i], free[k])] * unit[k] / assembly.unit(closed[i])
        });
        // A singular value below this is a branch point, as sin α = 1; there the direction stays as it is.
        let cutoff = 1e-13 * jacobian.amax();
        let Ok(change) = svd(jacobian).solve(&gap, cutoff) else { return };
        if change.iter().any(|x| !x.is_finite()) {
            return;
        }
        for (k, &i) in free.iter().enumerate() {
            q[i] -= change[k].clamp(-0.5, 0.5) * unit[k];
        }
    }
}
