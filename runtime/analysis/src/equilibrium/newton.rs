//! An equilibrium of one contact set by Newton's method on its tangent space: K δξ = ξ̈, until δξ
//! is lost in double-double.

use liftoff_core::model::ContactSet;
use liftoff_core::scalar::DoubleDouble;
use nalgebra::DVector;

use crate::Subject;
use crate::local::Local;

const ITERATIONS: usize = 80;
/// No step moves farther, in natural units.
const FARTHEST: f64 = 0.3;
/// Steps below this, in natural units, are the last but one.
const DONE: f64 = 1e-13;
/// Directions as soft as this part of natural stiffness are not moved along.
const SOFT: f64 = 1e-14;
/// Accelerations below this, in natural units, are none.
const AT_REST: f64 = 1e-11;
const HALVINGS: usize = 12;
const CLOSINGS: usize = 40;
/// Contacts are closed within this part of natural lengths.
const CLOSED: f64 = 1e-13;

/// The state at rest in an equilibrium of these contacts, if one is found from `state` by steps of
/// so many times the farthest.
pub(super) fn equilibrium(
    subject: &Subject,
    set: ContactSet,
    state: &[DoubleDouble],
    reach: f64,
) -> Option<Vec<DoubleDouble>> {
    let mut state = closed(subject, set, state.to_vec())?;
    let (unit, time) = (subject.unit(), subject.scales.time);
    let natural = |a: &DVector<f64>| a.norm() * time * time / unit;
    let mut is_last = false;
    for _ in 0..ITERATIONS {
        let local = Local::new(subject, set, &state).ok()?;
        let force = local.at_rest();
        if force.is_empty() || !force.iter().all(|a| a.is_finite()) {
            return force.is_empty().then_some(state);
        }
        let [stiffness, _] = local.derivatives();
        let step = stiffness.clone().svd(true, true).solve(&force, SOFT / (time * time)).ok()?;
        let length = step.norm() / unit;
        if is_last || length <= DONE && natural(&force) <= AT_REST {
            let state = closed(subject, set, local.state_at(&step))?;
            if is_last {
                return (natural(&force) <= AT_REST).then_some(state);
            }
            is_last = true;
            continue;
        }
        let mut step = step * (reach * FARTHEST / length).min(1.0);
        let better = |step: &DVector<f64>| {
            let state = closed(subject, set, local.state_at(step))?;
            let moved = Local::new(subject, set, &state).ok()?.at_rest();
            (natural(&moved) < natural(&force)).then_some(state)
        };
        let found = (0..HALVINGS).find_map(|_| {
            let found = better(&step);
            step *= 0.5;
            found
        });
        match found {
            Some(moved) => state = moved,
            None if natural(&force) <= AT_REST => return Some(state),
            None => return None,
        }
    }
    None
}

/// The state with the contacts of a set closed.
fn closed(subject: &Subject, set: ContactSet, mut state: Vec<DoubleDouble>) -> Option<Vec<DoubleDouble>> {
    let (layout, length) = (subject.layout(), subject.scales.length);
    for _ in 0..CLOSINGS {
        let equations = subject.system.equations(&state);
        let open = |row: usize| {
            let gap = equations.gap().get(row).map_or(0.0, |gap| gap.hi().abs());
            gap / layout.unit(row, length)
        };
        let rows =
            (0..layout.contacts.len() + layout.joints.len()).filter(|&row| layout.is_closed(row, &set));
        let most = rows.map(open).fold(0.0, f64::max);
        if !most.is_finite() {
            return None;
        }
        if most <= CLOSED {
            return Some(state);
        }
        subject.system.project(set, &mut state, length);
    }
    None
}
