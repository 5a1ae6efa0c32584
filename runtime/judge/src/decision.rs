//! Which contacts stay closed: 0 ≤ g̈ ⟂ λ ≥ 0, and where both are zero the same of their derivatives, order by order. With
//! W and b of the undecided contacts at order k (those that bear are kept closed),
//!
//! ```text
//! 0 ≤ g̈ₖ = W λₖ + bₖ ⟂ λₖ ≥ 0
//! ```
//!
//! λₖ > 0 bears from there on, g̈ₖ > 0 opens, both zero waits for the next order.

use crate::expansion::{Expansion, Kkt, Response, State};
use crate::numerics::complementarity;
use crate::numerics::linear::negligible;
use crate::scene::Scene;
use liftoff_core::scalar::Scalar;

/// What is not decided by then keeps still.
const ORDERS: usize = 8;
/// Rough contacts are decided by trying all sets: so many at most.
const TRIED: usize = 10;

/// What becomes of contacts that touch without speed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Decision {
    /// Those that bear, with the first order of their reactions that is not zero.
    pub bearing: Vec<(usize, usize)>,
    /// Those that stay closed by themselves, without a reaction of their own.
    pub idle: Vec<usize>,
    /// Those that open, with the first order of their gaps that is not zero.
    pub opening: Vec<(usize, usize)>,
}

/// Why nothing is decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Undecided {
    /// The equations contradict one another.
    Singular,
    /// There is no admissible set.
    Jammed,
    /// Too many rough contacts.
    Many,
}

struct Problem<S> {
    matrix: Vec<Vec<S>>,
    bias: Vec<S>,
    sizes: Vec<f64>,
    responses: Vec<Response<S>>,
    free: Response<S>,
}

/// Decides on the contacts that rest while others are held closed whatever their reactions.
pub(crate) fn decide<S: Scalar>(
    scene: &Scene<S>,
    state: &State<S>,
    (held, resting): (&[usize], &[usize]),
) -> Result<Decision, Undecided> {
    let mut decision = Decision { bearing: held.iter().map(|&i| (i, 0)).collect(), ..Decision::default() };
    let mut open: Vec<usize> = resting.to_vec();
    let mut expansion = Expansion::at(scene, state);
    let (mut largest, mut slow, mut first, mut names) = (0.0_f64, 0.0_f64, Vec::new(), Vec::new());
    let rough = resting.iter().any(|&i| scene.contacts[i].slip.is_some());
    for k in 0..ORDERS {
        let bearing: Vec<usize> = decision.bearing.iter().map(|&(i, _)| i).collect();
        let kkt = Kkt::of(scene, &expansion.series, scene.slots(&bearing));
        let mut problem = delassus(&expansion, &kkt, &open, k);
        if k == 0 {
            slow = expansion.pace(&problem.free.a);
            first = problem.sizes.clone();
            names = open.clone();
        }
        // Where nothing changes orders above the first are rounding of it.
        for (&contact, size) in open.iter().zip(&mut problem.sizes) {
            let of = names.iter().position(|&other| other == contact).map_or(0.0, |at| first[at]);
            *size = size.max(of * slow.powi(k as i32));
        }
        largest = largest.max(problem.free.size);
        if problem.free.contradicts(largest) {
            return Err(Undecided::Singular);
        }
        let outcome = match rough {
            true => tried(&expansion, &bearing, &open, (k, largest))?,
            false => {
                let (multipliers, opening) = smooth(&problem)?;
                let mut a = problem.free.a.clone();
                let mut all = problem.free.multipliers.clone();
                for (response, &z) in problem.responses.iter().zip(&multipliers) {
                    add(&mut a, &response.a, z);
                    add(&mut all, &response.multipliers, z);
                }
                Outcome { multipliers, opening, a, all, slots: kkt.slots }
            }
        };
        let (mut slots, mut all) = (outcome.slots.clone(), outcome.all.clone());
        if !rough {
            slots.extend(open.iter().map(|&i| crate::expansion::Slot::Contact(i)));
            all.extend(&outcome.multipliers);
        }
        expansion.push(&slots, k, &outcome.a, &all);
        let mut waiting = Vec::new();
        for (j, &contact) in open.iter().enumerate() {
            let tolerance = negligible::<S>() * problem.sizes[j];
            let own = problem.matrix[j][j].to_f64();
            if own * outcome.multipliers[j].to_f64() > tolerance {
                decision.bearing.push((contact, k));
            } else if outcome.opening[j].to_f64() > tolerance {
                decision.opening.push((contact, k + 2));
            } else {
                waiting.push(contact);
            }
        }
        open = waiting;
        if open.is_empty() {
            break;
        }
    }
    decision.idle = open;
    decision.bearing.drain(..held.len());
    Ok(decision)
}

struct Outcome<S> {
    multipliers: Vec<S>,
    opening: Vec<S>,
    a: Vec<S>,
    all: Vec<S>,
    slots: Vec<crate::expansion::Slot>,
}

fn add<S: Scalar>(sum: &mut [S], part: &[S], factor: S) {
    sum.iter_mut().zip(part).for_each(|(sum, &part)| *sum = *sum + part * factor);
}

fn delassus<S: Scalar>(expansion: &Expansion<S>, kkt: &Kkt<S>, open: &[usize], k: usize) -> Problem<S> {
    let scene = expansion.scene;
    let free = expansion.next(kkt, k);
    let (mut bias, mut sizes) = (Vec::new(), Vec::new());
    for &i in open {
        let row = &scene.contacts[i].row;
        let ((part, size), (along, other)) = (expansion.bias(row, k), expansion.along(row, &free.a));
        bias.push(part + along);
        sizes.push(size + other);
    }
    let responses: Vec<Response<S>> = open
        .iter()
        .map(|&i| {
            let mut force = vec![S::ZERO; scene.n()];
            for &(c, node) in &scene.contacts[i].row.gradient {
                force[c] = expansion.series.get(node, 0);
            }
            kkt.solve(&force, &vec![S::ZERO; kkt.slots.len()])
        })
        .collect();
    let entry = |i: usize, response: &Response<S>| expansion.along(&scene.contacts[i].row, &response.a).0;
    let matrix = open.iter().map(|&i| responses.iter().map(|r| entry(i, r)).collect()).collect();
    // Sums of rates that cancel are rounding of the largest among them.
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    sizes.iter_mut().for_each(|size| *size = size.max(1e-6 * largest));
    Problem { matrix, bias, sizes, responses, free }
}

/// λₖ and g̈ₖ of contacts without slip rows.
fn smooth<S: Scalar>(problem: &Problem<S>) -> Result<(Vec<S>, Vec<S>), Undecided> {
    let m = problem.bias.len();
    let bias = |j: usize| {
        let b = problem.bias[j];
        if b.abs().to_f64() <= negligible::<S>() * problem.sizes[j] { S::ZERO } else { b }
    };
    let own = |j: usize| problem.matrix[j][j].to_f64();
    let largest = (0..m).map(own).fold(0.0, f64::max);
    // What those that bear determine already has no reaction of its own.
    let free: Vec<usize> =
        (0..m).filter(|&j| own(j) > negligible::<S>() * largest.max(0.0) && own(j) > 0.0).collect();
    let scale: Vec<S> = free.iter().map(|&j| S::from_f64(own(j).sqrt().log2().round().exp2())).collect();
    let matrix: Vec<Vec<S>> = free
        .iter()
        .zip(&scale)
        .map(|(&i, &s)| free.iter().zip(&scale).map(|(&j, &r)| problem.matrix[i][j] / (s * r)).collect())
        .collect();
    let right: Vec<S> = free.iter().zip(&scale).map(|(&j, &s)| bias(j) / s).collect();
    let found = complementarity::solve(&matrix, &right).ok_or(Undecided::Jammed)?;
    let mut multipliers = vec![S::ZERO; m];
    free.iter().zip(&scale).zip(found).for_each(|((&j, &s), z)| multipliers[j] = z / s);
    let opening: Vec<S> =
        (0..m).map(|i| (0..m).fold(bias(i), |sum, j| sum + problem.matrix[i][j] * multipliers[j])).collect();
    let jammed =
        opening.iter().zip(&problem.sizes).any(|(w, size)| w.to_f64() < -negligible::<S>().sqrt() * size);
    if jammed { Err(Undecided::Jammed) } else { Ok((multipliers, opening)) }
}

/// The largest admissible set, with slips held in those that are closed.
fn tried<S: Scalar>(
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
        let kkt = Kkt::of(scene, &expansion.series, scene.slots(&closed));
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
