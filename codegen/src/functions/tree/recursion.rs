//! Accelerations by elimination from the leaves, as in Featherstone's articulated bodies (*Rigid Body Dynamics Algorithms*,
//! 2008, §7.2), here of the pairs (α, F) of a plane tree.
//!
//! With `F = A a + d` the force that drives a body at the point it turns about, those of the bodies that it carries
//! eliminated, its balance of forces and couples is
//!
//! ```text
//! F = B a + b α + r,   0 = J α + b · a + τ,
//! B = m 1 + Σ A,   b = p⊥ + Σ A e⊥,   J = I + Σ e⊥ · A e⊥,
//! r = −f − ω² p + Σ (d − ω² A e),   τ = −c + Σ e⊥ · (d − ω² A e),
//! ```
//!
//! with the sums over the carried bodies, f and c the loads. Then `α = −(b · a + τ)/J`, `A = B − b bᵀ/J`, `d = r − b τ/J`.

use super::geometry::{Geometry, signed};
use super::vector::{Vector, dot, normal, scaled_add, sub};
use crate::algebra::Series;
use crate::kinematics::Kinematics;
use crate::motion::{Motion, Tree};
use crate::program::{Id, Lowering, Program};
use crate::system::System;

/// What a branch, with all that hangs from it, is to its parent: `F = A a + d`.
struct Handle {
    /// A: xx, xy, yy.
    inertia: [Id; 3],
    /// d.
    bias: Vector,
}

/// The balance of a branch.
struct Balance {
    /// B.
    inertia: [Id; 3],
    /// b.
    moment: Vector,
    /// J.
    turning: Id,
    /// r.
    force: Vector,
    /// τ.
    couple: Id,
}

/// `α = −(k · a + ρ)`.
struct Turn {
    k: Vector,
    rho: Id,
}

/// The accelerations of a tree's coordinates.
pub fn accelerations(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    tree: &Tree,
) -> Vec<Id> {
    let mut lowering = Lowering::new(program, system, &motion.atoms, []);
    let geometry = Geometry::of(&mut lowering, system, kinematics, tree);
    let turns = inwards(&mut lowering, &geometry, motion);
    let (_, turned) = geometry.outwards(&mut lowering, |program, i, a| {
        let along = program.dot([(turns[i].k[0], a[0]), (turns[i].k[1], a[1])]);
        let sum = program.add(along, turns[i].rho);
        program.neg(sum)
    });
    let mut accelerations = vec![program.integer(0); motion.n];
    for (branch, alpha) in tree.branches.iter().zip(turned) {
        accelerations[branch.coordinate] = signed(program, branch.sign, alpha);
    }
    accelerations
}

fn inwards(lowering: &mut Lowering, geometry: &Geometry, motion: &Motion) -> Vec<Turn> {
    let mut balances = balances(lowering, geometry, motion);
    let program = lowering.program();
    let mut turns = Vec::new();
    for (i, branch) in geometry.tree.branches.iter().enumerate().rev() {
        let (turn, handle) = balances[i].eliminate(program);
        if let Some(parent) = branch.parent {
            balances[parent].carry(program, &handle, geometry.reach[i], geometry.square[parent]);
        }
        turns.push(turn);
    }
    turns.reverse();
    turns
}

/// Of each branch alone.
fn balances(lowering: &mut Lowering, geometry: &Geometry, motion: &Motion) -> Vec<Balance> {
    let (forces, couples) = geometry.loads(lowering, &motion.loads.actions);
    let one = |(i, branch): (usize, &crate::motion::Branch)| {
        let [mass, inertia] = [branch.mass(), branch.inertia()].map(|s: Series| lowering.series(&s));
        let program = lowering.program();
        let (first, zero) = (geometry.first[i], program.integer(0));
        let pull = scaled_add(program, geometry.square[i], first, forces[i]);
        Balance {
            inertia: [mass, zero, mass],
            moment: normal(program, first),
            turning: inertia,
            force: pull.map(|part| program.neg(part)),
            couple: program.neg(couples[i]),
        }
    };
    geometry.tree.branches.iter().enumerate().map(one).collect()
}

impl Balance {
    /// Adds what a carried branch at `reach` is.
    fn carry(&mut self, program: &mut Program, handle: &Handle, reach: Vector, square: Id) {
        let across = normal(program, reach);
        let moment = handle.times(program, across);
        let pull = reach.map(|part| program.mul(square, part));
        let centripetal = handle.times(program, pull);
        let bias = sub(program, handle.bias, centripetal);
        (0..3).for_each(|i| self.inertia[i] = program.add(self.inertia[i], handle.inertia[i]));
        self.turning = more(program, self.turning, across, moment);
        self.couple = more(program, self.couple, across, bias);
        (0..2).for_each(|i| self.moment[i] = program.add(self.moment[i], moment[i]));
        (0..2).for_each(|i| self.force[i] = program.add(self.force[i], bias[i]));
    }

    fn eliminate(&self, program: &mut Program) -> (Turn, Handle) {
        let one = program.integer(1);
        let inverse = program.div(one, self.turning);
        let k = self.moment.map(|part| program.mul(part, inverse));
        let rho = program.mul(self.couple, inverse);
        let minus = k.map(|part| program.neg(part));
        let [x, y] = self.moment;
        let inertia = [(x, minus[0]), (x, minus[1]), (y, minus[1])];
        let inertia = [0, 1, 2].map(|i| program.mul_add(inertia[i].0, inertia[i].1, self.inertia[i]));
        let bias = [0, 1].map(|i| program.mul_add(minus[i], self.couple, self.force[i]));
        (Turn { k, rho }, Handle { inertia, bias })
    }
}

impl Handle {
    /// A v.
    fn times(&self, program: &mut Program, v: Vector) -> Vector {
        let [xx, xy, yy] = self.inertia;
        [[xx, xy], [xy, yy]].map(|row| dot(program, row, v))
    }
}

/// s + a · b.
fn more(program: &mut Program, sum: Id, a: Vector, b: Vector) -> Id {
    let sum = program.mul_add(a[0], b[0], sum);
    program.mul_add(a[1], b[1], sum)
}
