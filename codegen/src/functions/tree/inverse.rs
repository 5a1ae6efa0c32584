//! Inverse dynamics: the force that drives each body at the point it turns about, and the couple
//! that would have to, at given accelerations,
//!
//! `F = m a + α p⊥ − ω² p − f + Σ F'`, `Q = I α + p⊥ · a − c + Σ e⊥ · F'`,
//!
//! sums over the bodies that it carries (Luh, Walker & Paul 1980).

use super::geometry::{TreeGeometry, signed};
use super::vector::{Vector, add, normal, scaled_add};
use crate::motion::Action;
use crate::program::{Id, Lowering};

/// What drives the branches of a tree.
pub(in crate::functions) struct Inverse {
    /// F.
    pub forces: Vec<Vector>,
    /// Q of each coordinate.
    pub couples: Vec<Id>,
}

impl Inverse {
    /// At these accelerations of the coordinates, under these loads.
    pub fn lower(
        lowering: &mut Lowering,
        geometry: &TreeGeometry,
        accelerations: &[Id],
        loads: &[Action],
    ) -> Self {
        let branches = &geometry.tree.branches;
        let (pulls, twists) = geometry.loads(lowering, loads);
        let (a, alpha) = geometry.outwards(lowering, |program, i, _| {
            signed(program, branches[i].sign, accelerations[branches[i].coordinate])
        });
        let masses: Vec<Id> = branches.iter().map(|branch| lowering.series(&branch.mass())).collect();
        let inertias: Vec<Id> = branches.iter().map(|branch| lowering.series(&branch.inertia())).collect();
        let program = lowering.program();
        let zero = program.integer(0);
        let (mut forces, mut couples) = (vec![[zero; 2]; branches.len()], vec![zero; branches.len()]);
        for (i, branch) in branches.iter().enumerate().rev() {
            let (across, minus) =
                (geometry.first_normal_add(program, i, [zero, zero]), program.neg(geometry.square[i]));
            let minus_pull = pulls[i].map(|part| program.neg(part));
            let force = scaled_add(program, masses[i], a[i], minus_pull);
            let force = geometry.first_add(program, i, minus, force);
            let force = scaled_add(program, alpha[i], across, force);
            forces[i] = add(program, forces[i], force);
            let twist = program.neg(twists[i]);
            let couple = program.mul_add(inertias[i], alpha[i], twist);
            let couple = program.mul_add(across[0], a[i][0], couple);
            let couple = program.mul_add(across[1], a[i][1], couple);
            let couple = program.add(couples[branch.coordinate], couple);
            couples[branch.coordinate] = signed(program, branch.sign, couple);
            if let Some(parent) = branch.parent {
                forces[parent] = add(program, forces[parent], forces[i]);
                let lever = normal(program, geometry.reach[i]);
                let above = branches[parent].coordinate;
                let sum = program.mul_add(lever[0], forces[i][0], couples[above]);
                couples[above] = program.mul_add(lever[1], forces[i][1], sum);
            }
        }
        Self { forces, couples }
    }
}
