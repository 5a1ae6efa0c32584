//! The cases that need no search: all touching contacts have clearly positive reactions, except at
//! most one, whose reaction is zero at a located event and clearly decreases.
//!
//! With the Delassus matrix W positive definite the complementarity problem has exactly one
//! solution; if λ > 0 solves it with g̈ = 0, that is the one. A smooth contact i with λᵢ = 0 in it
//! is decided by the next order, 0 ≤ g⃛ᵢ ⟂ λ̇ᵢ ≥ 0: it opens if λ̇ᵢ < 0 while it is closed.

pub(crate) mod slider;

use super::{ContactProblem, ContactSolution};
use crate::context::{Numbers, RunContext, reactions_of, reduce};
use crate::model::ContactSet;
use crate::numerics::zero::{MARGIN, SOLVED};
use crate::system::PhaseEquations;
use smallvec::smallvec;

/// Half the span of the central difference for the rate of a reaction, in natural times; its
/// relative error is the square of that.
const SPAN: f64 = 1e-4;

/// The decision, if this is such a case. Reactions come from `reduced`, the closed form of all
/// contacts that touch, where its chart is valid: it is well conditioned also where the rows of W
/// all but depend on each other.
pub(crate) fn decide(
    context: &RunContext,
    state: &[f64],
    question: &ContactProblem,
    reduced: Option<&dyn PhaseEquations>,
) -> Option<ContactSolution> {
    let layout = context.layout();
    let smooth = |i: usize| !layout.contacts[i].rough;
    let one =
        question.unloaded.is_empty() || question.unloaded.len() == 1 && question.unloaded.iter().all(smooth);
    if !one {
        return None;
    }
    let set = question.touching.union(question.held);
    let solve_after = |h: f64| match reduced {
        Some(phase) => reduced_reactions(phase, state, h),
        None => multipliers_after(context, state, set, h),
    };
    let mut reactions = solve_after(0.0)?;
    // Where nothing was located, the state is exact, and what a closed form gives has the rounding
    // of its terms.
    let is_exact = reduced.is_some() && question.unloaded.is_empty();
    let clear = if is_exact { SOLVED } else { MARGIN } * context.scales.force();
    let asked = question.touching.iter().filter(|&i| !question.held.contains(i));
    let mut bearing = asked.filter(|&i| !question.unloaded.contains(i));
    if !bearing.all(|i| reactions[i] > clear) {
        return None;
    }
    let mut closed = set;
    for i in question.unloaded.iter() {
        let h = SPAN * context.scales.time;
        let rate = (solve_after(h)?[i] - solve_after(-h)?[i]) / (2.0 * h);
        if rate * context.scales.time > -clear {
            return None;
        }
        closed = closed.without(i);
        reactions[i] = 0.0;
    }
    let (bearing, reactions) = (closed, reactions.to_vec());
    Some(ContactSolution { closed, active_basis: bearing, reactions, unique: true, alternatives: None })
}

/// Reactions of a closed form at `y + h ẏ`.
fn reduced_reactions(phase: &dyn PhaseEquations, state: &[f64], h: f64) -> Option<Numbers> {
    let info = phase.info();
    let (mut y, mut rates): (_, Numbers) = (reduce(phase, state), smallvec![0.0; info.entries]);
    phase.derivative(&y, &mut rates);
    y.iter_mut().zip(&rates).for_each(|(y, rate)| *y += h * rate);
    let mut reactions: Numbers = smallvec![0.0; phase.system().layout().reactions()];
    phase.reactions(&y, &mut reactions);
    reactions.iter().all(|x| x.is_finite()).then_some(reactions)
}

/// Reactions with the contacts of a set closed, by its multipliers, at `y + h ẏ`. The terms of
/// order h² that positions leave out cancel in the central difference.
fn multipliers_after(context: &RunContext, state: &[f64], set: ContactSet, h: f64) -> Option<Numbers> {
    let (accelerations, reactions) = solve(context, state, set)?;
    if h == 0.0 {
        return Some(reactions);
    }
    let n = accelerations.len();
    let entry = |k: usize| match k {
        _ if k < n => state[k] + h * state[n + k],
        _ if k < 2 * n => state[k] + h * accelerations[k - n],
        _ => state[k] + h,
    };
    let after: Numbers = (0..state.len()).map(entry).collect();
    Some(solve(context, &after, set)?.1)
}

/// Accelerations, and reactions of the contacts with those of `set` closed; None if they are not
/// determined.
pub(crate) fn solve(context: &RunContext, state: &[f64], set: ContactSet) -> Option<(Numbers, Numbers)> {
    let layout = context.layout();
    let mut accelerations: Numbers = smallvec![0.0; layout.coordinates.len()];
    let mut multipliers: Numbers = smallvec![0.0; layout.rows()];
    let unique = context.system().solve(state, set, &mut accelerations, &mut multipliers);
    let finite = accelerations.iter().chain(&multipliers).all(|x| x.is_finite());
    (unique && finite).then(|| (accelerations, reactions_of(layout, &multipliers)))
}

#[cfg(test)]
mod tests;
