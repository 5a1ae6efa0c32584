//! Impacts. With W of the joints alone and ġ⁻ of all contacts that touch: Newton, where none of them leaves already,
//!
//! ```text
//! 0 ≤ ġ⁺ + e ġ⁻ ⟂ P ≥ 0,    ġ⁺ = W P + ġ⁻
//! ```
//!
//! else, or where one that acts declares it, Poisson: 0 ≤ ġᶜ ⟂ Pᶜ ≥ 0, then 0 ≤ ġ⁺ ⟂ P − (1 + e) Pᶜ ≥ 0.

use crate::decision::Undecided;
use crate::expansion::{Expansion, Kkt, Response, State};
use crate::numerics::complementarity;
use crate::numerics::linear::negligible;
use crate::scene::Scene;
use liftoff_core::scalar::Scalar;

/// Rates after an impact.
pub(crate) struct Impact<S> {
    pub v: Vec<S>,
}

/// The impact of contacts that touch, with an applied impulse on the coordinates, while others are held
/// closed; `plastic`: without restitution.
pub(crate) fn collide<S: Scalar>(
    scene: &Scene<S>,
    state: &State<S>,
    (held, touching): (&[usize], &[usize]),
    applied: &[S],
    plastic: bool,
) -> Result<Impact<S>, Undecided> {
    if touching.iter().any(|&i| scene.contacts[i].slip.is_some()) {
        return rough(scene, state, (held, touching), applied);
    }
    let expansion = Expansion::at(scene, state);
    let kkt = Kkt::of(scene, &expansion.series, scene.slots(held));
    let zeros = vec![S::ZERO; kkt.slots.len()];
    let free = kkt.solve(applied, &zeros);
    let responses: Vec<Response<S>> = touching
        .iter()
        .map(|&i| {
            let mut force = vec![S::ZERO; scene.n()];
            for &(c, node) in &scene.contacts[i].row.gradient {
                force[c] = expansion.series.get(node, 0);
            }
            kkt.solve(&force, &zeros)
        })
        .collect();
    let along = |i: usize, a: &[S]| expansion.along(&scene.contacts[i].row, a).0;
    let matrix: Vec<Vec<S>> =
        touching.iter().map(|&i| responses.iter().map(|r| along(i, &r.a)).collect()).collect();
    let tolerance = negligible::<S>() * scene.speed(state);
    let approach: Vec<S> = touching
        .iter()
        .map(|&i| {
            let rate = expansion.rate(&scene.contacts[i].row);
            if rate.abs().to_f64() <= tolerance { S::ZERO } else { rate }
        })
        .collect();
    let pushed: Vec<S> = touching.iter().map(|&i| along(i, &free.a)).collect();
    let e = |j: usize| if plastic { S::ZERO } else { scene.contacts[touching[j]].restitution };
    let lcp = |bias: Vec<S>| complementarity::solve(&matrix, &bias).ok_or(Undecided::Jammed);
    let newton = |plastic: bool| {
        let e = |j: usize| if plastic { S::ZERO } else { e(j) };
        lcp((0..touching.len()).map(|j| approach[j] + pushed[j] + e(j) * approach[j]).collect())
    };
    let leaves = approach.iter().any(|&rate| rate > S::ZERO);
    let declared = || -> Result<bool, Undecided> {
        let acting = newton(true)?;
        Ok(touching.iter().zip(&acting).any(|(&i, &p)| scene.contacts[i].poisson && p > S::ZERO))
    };
    let impulses = if leaves || declared()? {
        let compression = lcp((0..touching.len()).map(|j| approach[j] + pushed[j]).collect())?;
        let expanded: Vec<S> = compression.iter().enumerate().map(|(j, &p)| p + e(j) * p).collect();
        let after = |i: usize| {
            (0..touching.len()).fold(approach[i] + pushed[i], |sum, j| sum + matrix[i][j] * expanded[j])
        };
        let rest = lcp((0..touching.len()).map(after).collect())?;
        expanded.iter().zip(rest).map(|(&a, b)| a + b).collect()
    } else {
        newton(false)?
    };
    let mut v: Vec<S> = state.v.iter().zip(&free.a).map(|(&v, &change)| v + change).collect();
    for (response, &impulse) in responses.iter().zip(&impulses) {
        v.iter_mut().zip(&response.a).for_each(|(v, &change)| *v = *v + change * impulse);
    }
    Ok(Impact { v })
}

/// Plastic contacts without slip where they act: the largest admissible set.
fn rough<S: Scalar>(
    scene: &Scene<S>,
    state: &State<S>,
    (held, touching): (&[usize], &[usize]),
    applied: &[S],
) -> Result<Impact<S>, Undecided> {
    if touching.len() > 10 || touching.iter().any(|&i| scene.contacts[i].restitution != S::ZERO) {
        return Err(Undecided::Many);
    }
    let expansion = Expansion::at(scene, state);
    let mut sets: Vec<u32> = (0..1_u32 << touching.len()).collect();
    sets.sort_by_key(|set| core::cmp::Reverse(set.count_ones()));
    let speed = scene.speed(state);
    for set in sets {
        let chosen = (0..touching.len()).filter(|&j| set & (1 << j) != 0).map(|j| touching[j]);
        let closed: Vec<usize> = held.iter().copied().chain(chosen).collect();
        let kkt = Kkt::of(scene, &expansion.series, scene.slots(&closed));
        let joints = scene.joints.len();
        let targets: Vec<S> = kkt
            .slots
            .iter()
            .enumerate()
            .map(|(r, &slot)| if r < joints { S::ZERO } else { -expansion.rate(scene.slot(slot)) })
            .collect();
        let response = kkt.solve(applied, &targets);
        let v: Vec<S> = state.v.iter().zip(&response.a).map(|(&v, &change)| v + change).collect();
        let after = |i: usize| {
            expansion.along(&scene.contacts[i].row, &v).0
                + expansion.series.get(scene.contacts[i].row.drift, 0)
        };
        let normal = &response.multipliers[joints..joints + closed.len()];
        let free = &normal[held.len()..];
        let size = normal.iter().map(|p| p.abs().to_f64()).fold(0.0, f64::max);
        let pushes = free.iter().all(|p| p.to_f64() >= -negligible::<S>() * size);
        let stays = touching.iter().all(|&i| after(i).to_f64() >= -negligible::<S>() * speed);
        if pushes && stays && !response.contradicts(0.0) {
            return Ok(Impact { v });
        }
    }
    Err(Undecided::Jammed)
}
