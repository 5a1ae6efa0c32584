//! Rough contacts, by trying.

use super::{Outcome, Undecided};
use crate::expansion::{Expansion, Kkt, Response};
use crate::numerics::linear::negligible;
use liftoff_core::scalar::Scalar;

/// Rough contacts are decided by trying all sets: so many at most.
const TRIED: usize = 10;

/// The largest admissible set, with slips held in those that are closed.
pub(super) fn tried<S: Scalar>(
    expansion: &Expansion<S>,
    bearing: &[usize],
    open: &[usize],
    (k, largest): (usize, f64),
) -> Result<Outcome<S>, Undecided> {
    let scene = expansion.scene;
    if open.len() > TRIED {
        return Err(Undecided::Many);
    }
    let mut sets: Vec<u32> = (0..1_u32 << open.len()).collect();
    sets.sort_by_key(|set| core::cmp::Reverse(set.count_ones()));
    for set in sets {
        let chosen = |j: usize| set & (1 << j) != 0;
        let closed: Vec<usize> =
            bearing.iter().copied().chain((0..open.len()).filter(|&j| chosen(j)).map(|j| open[j])).collect();
        let kkt = Kkt::assemble(scene, &expansion.series, scene.slots(&closed));
        let response = expansion.next(&kkt, k);
        let first = scene.joints.len() + bearing.len();
        let (mut multipliers, mut opening, mut admissible) = (Vec::new(), Vec::new(), true);
        let mut next = first;
        let force = response.multipliers.iter().map(|x| x.abs().to_f64()).fold(0.0, f64::max);
        for (j, &i) in open.iter().enumerate() {
            let row = &scene.contacts[i].row;
            let ((bias, size), (along, other)) = (expansion.bias(row, k), expansion.along(row, &response.a));
            let z = if chosen(j) { response.multipliers[next] } else { S::ZERO };
            next += usize::from(chosen(j));
            // A closed gap has no acceleration but rounding.
            let w = if chosen(j) { S::ZERO } else { bias + along };
            admissible &= z.to_f64() >= -negligible::<S>() * force;
            admissible &= w.to_f64() >= -negligible::<S>() * (size + other);
            multipliers.push(z);
            opening.push(w);
        }
        if admissible && !response.contradicts(largest) {
            let Response { a, multipliers: all, .. } = response;
            return Ok(Outcome { multipliers, opening, a, all, slots: kkt.slots });
        }
    }
    Err(Undecided::Jammed)
}
