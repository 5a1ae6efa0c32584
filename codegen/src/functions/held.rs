//! Motions that closed rows hold, without a closed form: a and λ of
//!
//! ```text
//! [ M  Jᵀ ] [  a ]   [  f ]
//! [ J  0  ] [ −λ ] = [ −b ]
//! ```
//!
//! by L D Lᵀ over named entries, M first, so that what follows is −J M⁻¹ Jᵀ; zeros are left out.
//! Where a tree is cheaper to eliminate from its leaves, `a = a₀ + Σ λ_k a_k`, a_k what the unit
//! force of row k does to it, with `(J M⁻¹ Jᵀ) λ = −(J a₀ + b)`, `a_k = M⁻¹ J_kᵀ`.

use super::{Kernel, Mass, PhaseFunctions, recursion};
use crate::algebra::{Series, Symbol};
use crate::kinematics::Kinematics;
use crate::motion::{ClosedSet, Motion, SEARCHED, UNROLLED};
use crate::program::{Factored, Id, Program};
use crate::system::System;

/// Contact sets that have code of their own at most.
const SETS: usize = 8;
/// Beside joints so many rows are closed in them at most.
const ROWS: usize = 8;
/// A set whose relative pivots are less than this in the nominal figure is held by rows that repeat
/// each other.
const LEAST_PIVOT: f64 = 1e-4;

/// What the closed rows of a contact set make of a motion.
#[derive(Clone, Debug)]
pub struct HeldMotion {
    /// The closed contacts, none of which slides.
    pub set: ClosedSet,
    /// Their rows and those of the joints.
    pub rows: Vec<usize>,
    /// u.
    pub rates: Vec<Id>,
    /// What is solved for.
    pub solution: HeldSolution,
}

/// What solves the equations of a motion that is held.
#[derive(Clone, Debug)]
pub struct HeldSolution {
    /// a.
    pub accelerations: Vec<Id>,
    /// λ of each closed row.
    pub multipliers: Vec<Id>,
    /// Of each row of M that varies, and of each closed one, its entry on the diagonal (of M, of J
    /// M⁻¹ Jᵀ) and the pivot that elimination makes of it: the smaller the pivot, the nearer are
    /// the rows to repeating each other.
    pub pivots: Vec<[Id; 2]>,
}

/// Of each set that has neither a closed form nor too many rows, by the cheaper elimination; none
/// where something that moves has no mass of its own, or hinges rub.
pub(super) fn held_motions(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    kernel: &Kernel,
    phases: &[PhaseFunctions],
) -> Vec<HeldMotion> {
    let massless = |body: &crate::motion::Inertia| body.mass.is_zero() || body.on.is_none();
    if motion.has_hinges() || motion.n > UNROLLED || motion.inertias.iter().any(massless) {
        return Vec::new();
    }
    let most = SETS.min(system.sets.saturating_sub(phases.len()));
    let (mut motions, mut own) = (Vec::new(), 0);
    for (set, rows) in candidates(motion, phases) {
        let joined = set.closed == 0;
        if !joined && own == most {
            break;
        }
        let solution = cheapest(program, system, kinematics, motion, kernel, &rows);
        if !joined && !is_regular(program, system, kinematics, motion, &solution) {
            continue;
        }
        own += usize::from(!joined);
        let rates = (0..motion.n).map(|i| program.input(Symbol::rate(i))).collect();
        motions.push(HeldMotion { set, rows, rates, solution });
    }
    motions
}

/// The sets that could have code of their own with the rows that are closed in them, smallest sets
/// first: without a closed form, with a freedom left, and with nothing that slides.
fn candidates<'a>(
    motion: &'a Motion,
    phases: &'a [PhaseFunctions],
) -> impl Iterator<Item = (ClosedSet, Vec<usize>)> + 'a {
    let sets = motion.sets(motion.contacts.len().min(SEARCHED)).into_iter();
    let open = sets
        .filter(|set| phases.iter().all(|phase| phase.set != *set) && motion.sliding(*set).next().is_none());
    let with_rows = open.map(|set| {
        let rows: Vec<usize> = (0..motion.rows.len()).filter(|&row| motion.is_closed(row, set)).collect();
        (set, rows)
    });
    with_rows.filter(|(set, rows)| {
        !rows.is_empty() && (set.closed == 0 || rows.len() < motion.n && rows.len() <= ROWS)
    })
}

fn cheapest(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    kernel: &Kernel,
    rows: &[usize],
) -> HeldSolution {
    let jacobian: Vec<Vec<Id>> = rows.iter().map(|&row| kernel.jacobian[row].clone()).collect();
    let bias: Vec<Id> = rows.iter().map(|&row| kernel.bias[row]).collect();
    let by_entries = match &kernel.mass {
        Mass::Entries(mass) => Some(HeldSolution::by_entries(program, mass, &kernel.force, &jacobian, &bias)),
        Mass::Paths(_) => None,
    };
    let by_tree = motion.tree.as_ref().map(|tree| {
        let free = recursion(program, system, kinematics, motion, tree, &jacobian);
        HeldSolution::from_free(program, &free, &jacobian, &bias)
    });
    let all = by_entries.into_iter().chain(by_tree);
    all.min_by_key(|solution| program.cycles(&solution.accelerations)).expect("a mass matrix or a tree")
}

/// Whether the rows do not repeat each other in the nominal figure.
fn is_regular(
    program: &Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    solution: &HeldSolution,
) -> bool {
    let Some(numbers) = system.samples.first() else { return false };
    let nominal = kinematics.nominal(system, numbers);
    let input = |symbol: Symbol| match symbol {
        Symbol::Parameter(_) => numbers.evaluate(&Series::symbol(symbol)),
        Symbol::Coordinate { index, order: 0 } if usize::from(index) < motion.n => {
            nominal[usize::from(index)]
        }
        _ => 0.0,
    };
    let values = program.evaluate(solution.pivots.as_flattened(), &input);
    values.chunks(2).all(|pair| pair[1] > LEAST_PIVOT * pair[0])
}

impl HeldSolution {
    /// From the lower triangle of M, f, and rows with `jacobian` and `bias`.
    pub fn by_entries(
        program: &mut Program,
        mass: &[Vec<Id>],
        force: &[Id],
        jacobian: &[Vec<Id>],
        bias: &[Id],
    ) -> Self {
        let (n, zero) = (mass.len(), program.integer(0));
        let borders = jacobian.iter().enumerate().map(|(k, row)| [&row[..], &vec![zero; k + 1]].concat());
        let bordered: Vec<Vec<Id>> = mass.iter().cloned().chain(borders).collect();
        let right: Vec<Id> =
            force.iter().copied().chain(bias.iter().map(|&bias| program.neg(bias))).collect();
        let factored = Factored::bordered(program, &bordered, n);
        let mut unknowns = factored.solve(program, &right);
        let multipliers = unknowns.split_off(n).into_iter().map(|x| program.neg(x)).collect();
        let pairs = factored.diagonal.iter().zip(&factored.pivots).map(|(&entry, &pivot)| [entry, pivot]);
        let pairs: Vec<[Id; 2]> = pairs.collect();
        let (masses, rows) = pairs.split_at(n);
        let varying = masses.iter().filter(|[_, pivot]| !program.is_constant(*pivot));
        let mut pivots: Vec<[Id; 2]> = varying.copied().collect();
        pivots.extend(rows.iter().map(|pair| pair.map(|value| program.neg(value))));
        Self { accelerations: unknowns, multipliers, pivots }
    }

    /// From a₀ and every a_k, for rows with `jacobian` and `bias`.
    pub fn from_free(program: &mut Program, free: &[Vec<Id>], jacobian: &[Vec<Id>], bias: &[Id]) -> Self {
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
        let factored = Factored::factor(program, &compliance);
        let multipliers = factored.solve(program, &right);
        let pivots = compliance.iter().zip(&factored.pivots).map(|(row, &pivot)| [row[row.len() - 1], pivot]);
        let pivots = pivots.collect();
        let accelerations = (0..first.len()).map(|i| {
            let parts = units.iter().zip(&multipliers).map(|(unit, &lambda)| (unit[i], lambda));
            parts.fold(first[i], |sum, (a, lambda)| program.mul_add(a, lambda, sum))
        });
        Self { accelerations: accelerations.collect(), multipliers, pivots }
    }
}
