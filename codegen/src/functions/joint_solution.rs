//! Accelerations of a system that joints hold, from those that it would have without: `a = a₀ + Σ λ_k a_k`, a_k what the
//! unit force of joint k does to it, with
//!
//! `(J M⁻¹ Jᵀ) λ = −(J a₀ + b)`, `a_k = M⁻¹ J_kᵀ`.

use super::{Kernel, Mass, recursion};
use crate::algebra::Symbol;
use crate::kinematics::Kinematics;
use crate::motion::{Motion, UNROLLED};
use crate::program::{Factored, Id, Program};
use crate::system::System;

/// What joints make of a motion without contacts.
#[derive(Clone, Debug)]
pub struct JointSolution {
    /// u.
    pub rates: Vec<Id>,
    /// a.
    pub accelerations: Vec<Id>,
    /// Of each joint its entry on the diagonal of J M⁻¹ Jᵀ and the pivot that elimination makes of it: the smaller the
    /// pivot, the nearer are the joints to repeating each other.
    pub pivots: Vec<[Id; 2]>,
}

/// By the cheaper of the elimination from the leaves and that of M; `None` without joints, and where something that
/// moves has no mass of its own.
pub(super) fn joint_solution(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    kernel: &Kernel,
) -> Option<JointSolution> {
    let joints = motion.contacts.len()..motion.slips();
    let massless = |body: &crate::motion::Inertia| body.mass.is_zero() || body.on.is_none();
    if joints.is_empty() || motion.n > UNROLLED || motion.inertias.iter().any(massless) {
        return None;
    }
    let rows = &kernel.jacobian[joints.clone()];
    let by_tree = motion.tree.as_ref().map(|tree| recursion(program, system, kinematics, motion, tree, rows));
    let by_entries = match &kernel.mass {
        Mass::Entries(mass) => {
            let factored = Factored::of(program, mass);
            let forces = core::iter::once(&kernel.force).chain(rows);
            Some(forces.map(|force| factored.solve(program, force)).collect::<Vec<_>>())
        }
        Mass::Paths(_) => None,
    };
    let candidates = [by_tree, by_entries].into_iter().flatten();
    let candidates: Vec<JointSolution> = candidates
        .map(|free| JointSolution::of(program, &free, rows, &kernel.bias[joints.clone()]))
        .collect();
    candidates.into_iter().min_by_key(|joint_solution| program.cycles(&joint_solution.accelerations))
}

impl JointSolution {
    /// From a₀ and every a_k, for joints with the rows `jacobian` and `bias`.
    pub fn of(program: &mut Program, free: &[Vec<Id>], jacobian: &[Vec<Id>], bias: &[Id]) -> Self {
        let (first, units) = (&free[0], &free[1..]);
        let along = |program: &mut Program, row: &[Id], a: &[Id]| {
            program.dot(row.iter().copied().zip(a.iter().copied()))
        };
        let entries = |program: &mut Program, k: usize| {
            units[..=k].iter().map(|unit| along(program, &jacobian[k], unit)).collect::<Vec<Id>>()
        };
        let compliance: Vec<Vec<Id>> = (0..units.len()).map(|k| entries(program, k)).collect();
        let right = jacobian.iter().zip(bias).map(|(row, &bias)| {
            let rate = along(program, row, first);
            let sum = program.add(rate, bias);
            program.neg(sum)
        });
        let right: Vec<Id> = right.collect();
        let factored = Factored::of(program, &compliance);
        let multipliers = factored.solve(program, &right);
        let pivots = compliance.iter().zip(&factored.pivots).map(|(row, &pivot)| [row[row.len() - 1], pivot]);
        let pivots = pivots.collect();
        let accelerations = (0..first.len()).map(|i| {
            let parts = units.iter().zip(&multipliers).map(|(unit, &lambda)| (unit[i], lambda));
            parts.fold(first[i], |sum, (a, lambda)| program.mul_add(a, lambda, sum))
        });
        let accelerations: Vec<Id> = accelerations.collect();
        let rates = (0..first.len()).map(|i| program.input(Symbol::rate(i))).collect();
        Self { rates, accelerations, pivots }
    }
}
