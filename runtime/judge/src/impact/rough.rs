//! Impacts of rough contacts, by trying.

use super::Impact;
use crate::decision::Undecided;
use crate::expansion::{Expansion, Kkt, State};
use crate::numerics::linear::negligible;
use crate::scene::Scene;
use liftoff_core::scalar::Scalar;

/// Plastic contacts without slip where they act: the largest admissible set.
pub(super) fn rough<S: Scalar>(
    scene: &Scene<S>,
    state: &State<S>,
    (held, touching): (&[usize], &[usize]),
    applied: &[S],
) -> Result<Impact<S>, Undecided> {
    if touching.len() > 10 || touching.iter().any(|&i| scene.contacts[i].restitution != S::ZERO) {
        return Err(Undecided::Many);
    }
    let expansion = Expansion::new(scene, state);
    let mut sets: Vec<u32> = (0..1_u32 << touching.len()).collect();
    sets.sort_by_key(|set| core::cmp::Reverse(set.count_ones()));
    let speed = scene.speed(state);
    for set in sets {
        let chosen = (0..touching.len()).filter(|&j| set & (1 << j) != 0).map(|j| touching[j]);
        let closed: Vec<usize> = held.iter().copied().chain(chosen).collect();
        let kkt = Kkt::assemble(scene, &expansion.series, scene.slots(&closed));
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
                + expansion.series.get(scene.contacts[i].row.prescribed_gap_rate, 0)
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
