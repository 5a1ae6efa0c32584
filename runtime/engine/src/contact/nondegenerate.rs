//! The cases that need no search: all touching contacts have clearly positive reactions, except at most one, whose reaction is
//! zero at a located event and clearly decreases.
//!
//! With the Delassus matrix W positive definite the complementarity problem has exactly one solution; if λ > 0 solves it with
//! g̈ = 0, that is the one. A smooth contact i with λᵢ = 0 in it is decided by the next order, 0 ≤ g⃛ᵢ ⟂ λ̇ᵢ ≥ 0: it opens if
//! λ̇ᵢ < 0 while it is closed.

use super::{ContactProblem, ContactSolution};
use crate::integration::phase_point::{Numbers, RunContext, reactions_of};
use crate::model::ContactSet;
use smallvec::smallvec;

/// A reaction, or its change in one natural time, is clearly nonzero above this fraction of the natural force.
pub(super) const CLEAR: f64 = 1e-6;
/// Half the span of the central difference for the rate of a reaction, in natural times; its relative error is the square of
/// that.
const SPAN: f64 = 1e-4;

/// The decision, if this is such a case.
pub(crate) fn decide(
    context: &RunContext,
    state: &[f64],
    question: &ContactProblem,
) -> Option<ContactSolution> {
    let layout = context.layout();
    let smooth = |i: usize| !layout.contacts[i].rough;
    let one =
        question.unloaded.is_empty() || question.unloaded.len() == 1 && question.unloaded.iter().all(smooth);
    if !one {
        return None;
    }
    let set = question.touching.union(question.held);
    let (accelerations, mut reactions) = solve(context, state, set)?;
    let clear = CLEAR * context.scales.force();
    let asked = question.touching.iter().filter(|&i| !question.held.contains(i));
    let mut bearing = asked.filter(|&i| !question.unloaded.contains(i));
    if !bearing.all(|i| reactions[i] > clear) {
        return None;
    }
    let mut closed = set;
    for i in question.unloaded.iter() {
        if reaction_rate(context, state, &accelerations, (set, i))? * context.scales.time > -clear {
            return None;
        }
        closed = closed.without(i);
        reactions[i] = 0.0;
    }
    let (bearing, reactions) = (closed, reactions.to_vec());
    Some(ContactSolution { closed, bearing, reactions, unique: true, alternatives: None })
}

/// Accelerations, and reactions of the contacts with those of `set` closed; None if they are not determined.
pub(super) fn solve(context: &RunContext, state: &[f64], set: ContactSet) -> Option<(Numbers, Numbers)> {
    let layout = context.layout();
    let mut accelerations: Numbers = smallvec![0.0; layout.coordinates.len()];
    let mut multipliers: Numbers = smallvec![0.0; layout.rows()];
    let unique = context.system().solve(state, set, &mut accelerations, &mut multipliers);
    let finite = accelerations.iter().chain(&multipliers).all(|x| x.is_finite());
    (unique && finite).then(|| (accelerations, reactions_of(layout, &multipliers)))
}

/// λ̇ of contact `i` with the contacts of a set closed, by a central difference along the motion.
fn reaction_rate(
    context: &RunContext,
    state: &[f64],
    a: &[f64],
    (set, i): (ContactSet, usize),
) -> Option<f64> {
    let (n, h, y) = (a.len(), SPAN * context.scales.time, state);
    let after = |h: f64| -> Numbers {
        let entry = |k: usize| match k {
            // The terms of order h² cancel in the difference.
            _ if k < n => y[k] + h * y[n + k],
            _ if k < 2 * n => y[k] + h * a[k - n],
            _ => y[k] + h,
        };
        (0..y.len()).map(entry).collect()
    };
    let [before, after] = [after(-h), after(h)].map(|state| solve(context, &state, set));
    Some((after?.1[i] - before?.1[i]) / (2.0 * h))
}

#[cfg(test)]
mod tests;
