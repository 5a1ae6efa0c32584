//! The cases that need no search: every contact that touches clearly bears, but for at most one whose reaction was
//! located at zero and clearly falls.
//!
//! With W positive definite the contact conditions have one solution. All λ > 0 with g̈ = 0 is it. A smooth contact i
//! with λᵢ = 0 in the same solution leaves order 1 to decide, 0 ≤ g⃛ᵢ ⟂ λ̇ᵢ ≥ 0: where λ̇ᵢ < 0 with the contact closed, it
//! opens.

use super::{Decision, Question};
use crate::model::{Array, BarSystem, ContactSet, KernelView};
use crate::moment::Scene;

/// A reaction or its change in a natural time is clear above this part of the natural force.
const CLEAR: f64 = 1e-6;
/// The slope of a reaction is taken over this part of a natural time, to its square.
const SPAN: f64 = 1e-4;

/// The decision, if this is such a case.
pub(crate) fn decide<M: BarSystem>(
    scene: &Scene<M>,
    state: &M::State<f64>,
    question: &Question,
) -> Option<Decision> {
    let smooth = |i: usize| !M::LAYOUT.contacts[i].rough;
    let one =
        question.unloaded.is_empty() || question.unloaded.len() == 1 && question.unloaded.iter().all(smooth);
    if !one {
        return None;
    }
    let set = ContactSet(question.touching.0 | question.held.0);
    let (accelerations, mut reactions) = solve(scene, state, set)?;
    let clear = CLEAR * scene.scales.force();
    let asked = question.touching.iter().filter(|&i| !question.held.contains(i));
    let mut bearing = asked.filter(|&i| !question.unloaded.contains(i));
    if !bearing.all(|i| reactions[i] > clear) {
        return None;
    }
    let mut closed = set;
    for i in question.unloaded.iter() {
        if slope(scene, state, &accelerations, (set, i))? * scene.scales.time > -clear {
            return None;
        }
        closed = ContactSet(closed.0 & !(1 << i));
        reactions[i] = 0.0;
    }
    Some(Decision { closed, reactions, unique: true })
}

/// Accelerations, and reactions of the contacts with those of `set` closed; None if they are not determined.
fn solve<M: BarSystem>(
    scene: &Scene<M>,
    state: &M::State<f64>,
    set: ContactSet,
) -> Option<(M::Accelerations<f64>, Vec<f64>)> {
    let mut accelerations = M::Accelerations::from_fn(|_| 0.0);
    let mut multipliers = M::Multipliers::from_fn(|_| 0.0);
    let kernel = M::kernel(&scene.constants, state);
    let unique = kernel.solve(M::LAYOUT, set, accelerations.as_mut(), multipliers.as_mut());
    let finite = accelerations.as_ref().iter().chain(multipliers.as_ref()).all(|x| x.is_finite());
    let reactions = || multipliers.as_ref()[..M::LAYOUT.contacts.len()].to_vec();
    (unique && finite).then(|| (accelerations, reactions()))
}

/// λ̇ of contact `i` with the contacts of a set closed, by a central difference along the motion.
fn slope<M: BarSystem>(
    scene: &Scene<M>,
    state: &M::State<f64>,
    accelerations: &M::Accelerations<f64>,
    (set, i): (ContactSet, usize),
) -> Option<f64> {
    let (n, h) = (M::LAYOUT.coordinates.len(), SPAN * scene.scales.time);
    let (y, a) = (state.as_ref(), accelerations.as_ref());
    let after = |h: f64| {
        M::State::from_fn(|k| match k {
            _ if k < n => y[k] + h * (y[n + k] + 0.5 * h * a[k]),
            _ if k < 2 * n => y[k] + h * a[k - n],
            _ => y[k] + h,
        })
    };
    let [before, after] = [after(-h), after(h)].map(|state| solve(scene, &state, set));
    Some((after?.1[i] - before?.1[i]) / (2.0 * h))
}
