//! Accelerations by elimination from the leaves, as in Featherstone's articulated bodies (*Rigid
//! Body Dynamics Algorithms*, 2008, §7.2), here of the pairs (α, F) of a plane tree.
//!
//! With `F = A a + d` the force that drives a body at the point it turns about, those of the bodies
//! that it carries eliminated, its balance of forces and couples is
//!
//! ```text
//! F = B a + b α + r,   0 = J α + b · a + τ,
//! B = m 1 + Σ A,   b = p⊥ + Σ A e⊥,   J = I + Σ e⊥ · A e⊥,
//! r = −f − ω² p + Σ (d − ω² A e),   τ = −c + Σ e⊥ · (d − ω² A e),
//! ```
//!
//! with the sums over the carried bodies, f and c the loads. Then `α = −(b · a + τ)/J`,
//! `A = B − b bᵀ/J`, `d = r − b τ/J`. At a free point that a force s drives, `Σ A a + Σ d = s`.

use super::factors::{Factor, Factors, times_add};
use super::geometry::{TreeGeometry, signed};
use super::vector::{Vector, add, dot_add, normal, scaled_add, sub};
use crate::kinematics::Kinematics;
use crate::motion::{Motion, Tree};
use crate::program::{Id, Lowering, Program, solve_symmetric};
use crate::system::System;

/// What acts on a tree.
struct TreeLoads {
    /// f on each branch.
    forces: Vec<Vector>,
    /// c on each branch about the point it turns about.
    couples: Vec<Id>,
    /// s at each base.
    bases: Vec<Vector>,
    /// a of the ground where the tree moves; nothing for what a load alone does to a tree at rest.
    ground: Option<Vector>,
}

/// What a branch is to its parent: `F = A a + d`, and `α = −(k · a + ρ)`.
struct Bias {
    d: Vector,
    rho: Id,
}

/// The accelerations of a tree's coordinates, then what unit values of the generalised forces do to
/// them.
pub fn accelerations(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    tree: &Tree,
    forces: &[Vec<Id>],
) -> Vec<Vec<Id>> {
    let mut lowering = Lowering::new(program, system, &motion.opaque_terms, []);
    let geometry = TreeGeometry::lower(&mut lowering, system, kinematics, tree);
    let factors = Factors::lower(&mut lowering, &geometry);
    let (pulls, couples) = geometry.loads(&mut lowering, &motion.loads.actions);
    let ground = Some(geometry.ground(&mut lowering));
    let zero = program.integer(0);
    let bases = vec![[zero; 2]; tree.bases.len()];
    let moving = TreeLoads { forces: pulls, couples, bases, ground };
    let units: Vec<TreeLoads> =
        forces.iter().map(|force| TreeLoads::generalised(program, tree, force)).collect();
    let drives = core::iter::once(moving).chain(units);
    drives.map(|drive| drive.accelerate(program, &geometry, &factors, motion.n)).collect()
}

impl TreeLoads {
    /// Generalised forces alone.
    fn generalised(program: &mut Program, tree: &Tree, force: &[Id]) -> Self {
        let zero = program.integer(0);
        let couples = tree.branches.iter().map(|b| signed(program, b.sign, force[b.coordinate])).collect();
        let at =
            |base: &crate::motion::Base| base.coordinates.map(|(i, sign)| signed(program, sign, force[i]));
        let bases = tree.bases.iter().map(at).collect();
        Self { forces: vec![[zero; 2]; tree.branches.len()], couples, bases, ground: None }
    }

    fn accelerate(
        &self,
        program: &mut Program,
        geometry: &TreeGeometry,
        factors: &Factors,
        n: usize,
    ) -> Vec<Id> {
        let biases = self.inwards(program, geometry, &factors.branches);
        let zero = program.integer(0);
        let ground = self.ground.unwrap_or([zero; 2]);
        let mut accelerations = vec![zero; n];
        let mut bases = Vec::new();
        for (i, base) in geometry.tree.bases.iter().enumerate() {
            let begins = |branch: &usize| geometry.tree.branches[*branch].base == Some(i);
            let beginning = (0..biases.len()).filter(begins);
            let rest = beginning.fold(self.bases[i], |rest, branch| sub(program, rest, biases[branch].d));
            let [xx, xy, yy] = factors.bases[i];
            let a = solve_symmetric(program, &[vec![xx], vec![xy, yy]], &rest);
            for (axis, (coordinate, sign)) in base.coordinates.into_iter().enumerate() {
                let acceleration = program.sub(a[axis], ground[axis]);
                accelerations[coordinate] = signed(program, sign, acceleration);
            }
            bases.push([a[0], a[1]]);
        }
        let (mut carried, mut turned): (Vec<Vector>, Vec<Id>) = (Vec::new(), Vec::new());
        for (i, branch) in geometry.tree.branches.iter().enumerate() {
            let a = match (branch.parent, branch.base) {
                (None, None) => ground,
                (None, Some(base)) => bases[base],
                (Some(parent), _) => {
                    let across = normal(program, geometry.reach[i]);
                    let a = self.outwards(program, geometry, i, parent, carried[parent]);
                    scaled_add(program, turned[parent], across, a)
                }
            };
            let sum = dot_add(program, factors.branches[i].k, a, biases[i].rho);
            turned.push(program.neg(sum));
            carried.push(a);
            accelerations[branch.coordinate] = signed(program, branch.sign, turned[i]);
        }
        accelerations
    }

    /// v − ω² e from a branch's parent, v of a tree at rest.
    fn outwards(
        &self,
        program: &mut Program,
        geometry: &TreeGeometry,
        i: usize,
        parent: usize,
        v: Vector,
    ) -> Vector {
        if self.ground.is_none() {
            return v;
        }
        let minus = program.neg(geometry.square[parent]);
        scaled_add(program, minus, geometry.reach[i], v)
    }

    fn inwards(&self, program: &mut Program, geometry: &TreeGeometry, factors: &[Factor]) -> Vec<Bias> {
        let mut forces: Vec<Vector> = self.forces.iter().map(|f| f.map(|part| program.neg(part))).collect();
        let mut couples: Vec<Id> = self.couples.iter().map(|&couple| program.neg(couple)).collect();
        let (mut biases, zero) = (Vec::new(), program.integer(0));
        for (i, branch) in geometry.tree.branches.iter().enumerate().rev() {
            if self.ground.is_some() {
                let minus = program.neg(geometry.square[i]);
                forces[i] = geometry.first_add(program, i, minus, forces[i]);
            }
            let Factor { k, inverse, inertia } = &factors[i];
            let minus = program.neg(couples[i]);
            let (d, rho) = (scaled_add(program, minus, *k, forces[i]), program.mul(couples[i], *inverse));
            if let Some(parent) = branch.parent {
                let pull = self.outwards(program, geometry, i, parent, [zero; 2]);
                let bias = times_add(program, *inertia, pull, d);
                let across = normal(program, geometry.reach[i]);
                couples[parent] = dot_add(program, across, bias, couples[parent]);
                forces[parent] = add(program, forces[parent], bias);
            }
            biases.push(Bias { d, rho });
        }
        biases.reverse();
        biases
    }
}
