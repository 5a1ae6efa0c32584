//! Contacts without slip rows: one complementarity problem at each order.

use super::Undecided;
use crate::expansion::{Expansion, Kkt, Response};
use crate::numerics::complementarity;
use crate::numerics::linear::negligible;
use liftoff_core::scalar::Scalar;

/// What the undecided contacts do at an order, by unit reactions.
pub(super) struct Problem<S> {
    pub matrix: Vec<Vec<S>>,
    pub bias: Vec<S>,
    pub sizes: Vec<f64>,
    pub responses: Vec<Response<S>>,
    pub free: Response<S>,
}

/// The problem of order k of contacts that are open.
pub(super) fn delassus<S: Scalar>(
    expansion: &Expansion<S>,
    kkt: &Kkt<S>,
    open: &[usize],
    k: usize,
) -> Problem<S> {
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
pub(super) fn smooth<S: Scalar>(problem: &Problem<S>) -> Result<(Vec<S>, Vec<S>), Undecided> {
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
