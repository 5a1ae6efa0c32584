//! Where the bodies of a tree reach, and what acts on them.

use super::vector::{Vector, add, dot_add, normal, scaled_add};
use crate::algebra::{Series, Symbol};
use crate::kinematics::Kinematics;
use crate::motion::{Action, Branch, Holder, Tree};
use crate::program::{Id, Lowering, Program};
use crate::system::System;

/// A tree at a state; each list has an entry for each branch.
pub(in crate::functions) struct TreeGeometry<'a> {
    pub system: &'a System,
    pub kinematics: &'a Kinematics,
    pub tree: &'a Tree,
    /// (cos δ, sin δ) of its direction.
    axes: Vec<Vector>,
    /// e from the parent's point to its own.
    pub reach: Vec<Vector>,
    /// p in its frame.
    first: Vec<Vector>,
    /// ω.
    pub spin: Vec<Id>,
    /// ω².
    pub square: Vec<Id>,
}

impl<'a> TreeGeometry<'a> {
    pub fn lower(
        lowering: &mut Lowering,
        system: &'a System,
        kinematics: &'a Kinematics,
        tree: &'a Tree,
    ) -> Self {
        let mut geometry = Self {
            system,
            kinematics,
            tree,
            axes: Vec::new(),
            reach: Vec::new(),
            first: Vec::new(),
            spin: Vec::new(),
            square: Vec::new(),
        };
        for branch in &tree.branches {
            let direction = &kinematics.directions[branch.body];
            let axes = [Series::cos(direction), Series::sin(direction)].map(|wave| lowering.series(&wave));
            geometry.axes.push(axes);
            let reach = match branch.parent {
                Some(parent) => geometry.turned(lowering, parent, &branch.reach),
                None => branch.reach.each_ref().map(|part| lowering.series(part)),
            };
            geometry.reach.push(reach);
            geometry.first.push(branch.first().each_ref().map(|part| lowering.series(part)));
            let rate = lowering.symbol(Symbol::rate(branch.coordinate));
            let spin = signed(lowering.program(), branch.sign, rate);
            geometry.spin.push(spin);
            geometry.square.push(lowering.program().mul(rate, rate));
        }
        geometry
    }

    /// A vector of a branch's frame.
    pub fn turned(&self, lowering: &mut Lowering, branch: usize, local: &[Series; 2]) -> Vector {
        let local = local.each_ref().map(|part| lowering.series(part));
        let zero = lowering.program().integer(0);
        self.turned_add(lowering.program(), branch, local, [zero, zero])
    }

    /// The same, of values, and w.
    fn turned_add(&self, program: &mut Program, branch: usize, [along, across]: Vector, w: Vector) -> Vector {
        let [cos, sin] = self.axes[branch];
        let minus = program.neg(across);
        [
            dot_add(program, [along, minus], [cos, sin], w[0]),
            dot_add(program, [along, across], [sin, cos], w[1]),
        ]
    }

    /// k p + w.
    pub fn first_add(&self, program: &mut Program, branch: usize, k: Id, w: Vector) -> Vector {
        let local = self.first[branch].map(|part| program.mul(k, part));
        self.turned_add(program, branch, local, w)
    }

    /// p⊥ + w.
    pub fn first_normal_add(&self, program: &mut Program, branch: usize, w: Vector) -> Vector {
        let local = normal(program, self.first[branch]);
        self.turned_add(program, branch, local, w)
    }

    /// The force of these actions on each branch, and their couple about its point.
    pub fn loads(&self, lowering: &mut Lowering, actions: &[Action]) -> (Vec<Vector>, Vec<Id>) {
        let on = |branch: &'a Branch| {
            let from = &self.kinematics.points[self.kinematics.tree.entry[branch.body]];
            let (mut force, mut couple) = ([Series::zero(), Series::zero()], Series::zero());
            for action in actions.iter().filter(|action| action.on == Some(Holder::Body(branch.body))) {
                let arm = [0, 1].map(|axis| &action.at[axis] - &from[axis]);
                couple += &(&arm[0] * &action.force[1]) - &(&arm[1] * &action.force[0]);
                couple += action.couple.clone();
                (0..2).for_each(|axis| force[axis] += action.force[axis].clone());
            }
            (force, couple)
        };
        let loads = self.tree.branches.iter().map(on);
        loads
            .map(|(force, couple)| (force.each_ref().map(|f| lowering.series(f)), lowering.series(&couple)))
            .unzip()
    }

    /// a and α of each branch, from the ground outwards: `a' = a + α e⊥ − ω² e`, α by `turn` from
    /// the branch and its a.
    pub fn outwards(
        &self,
        lowering: &mut Lowering,
        mut turn: impl FnMut(&mut Program, usize, Vector) -> Id,
    ) -> (Vec<Vector>, Vec<Id>) {
        let ground = self.ground(lowering);
        let program = lowering.program();
        let (mut carried, mut turned): (Vec<Vector>, Vec<Id>) = (Vec::new(), Vec::new());
        for (i, branch) in self.tree.branches.iter().enumerate() {
            let a = branch.parent.map_or(ground, |parent| {
                let (reach, minus) = (self.reach[i], program.neg(self.square[parent]));
                let across = normal(program, reach);
                let a = scaled_add(program, minus, reach, carried[parent]);
                scaled_add(program, turned[parent], across, a)
            });
            turned.push(turn(program, i, a));
            carried.push(a);
        }
        (carried, turned)
    }

    /// −g: so the ground accelerates against free fall.
    pub fn ground(&self, lowering: &mut Lowering) -> Vector {
        let gravity = self.system.gravity.clone().unwrap_or_else(|| [Series::zero(), Series::zero()]);
        gravity.map(|g| lowering.series(&-&g))
    }

    /// The velocity of the point that each branch turns about: `v' = v + ω e⊥`.
    pub fn velocities(&self, program: &mut Program) -> Vec<Vector> {
        let zero = program.integer(0);
        let mut velocities: Vec<Vector> = Vec::new();
        for (i, branch) in self.tree.branches.iter().enumerate() {
            let velocity = branch.parent.map_or([zero, zero], |parent| {
                let across = normal(program, self.reach[i]);
                scaled_add(program, self.spin[parent], across, velocities[parent])
            });
            velocities.push(velocity);
        }
        velocities
    }

    /// Where that point is.
    pub fn places(&self, program: &mut Program) -> Vec<Vector> {
        let mut places: Vec<Vector> = Vec::new();
        for (i, branch) in self.tree.branches.iter().enumerate() {
            let place =
                branch.parent.map_or(self.reach[i], |parent| add(program, places[parent], self.reach[i]));
            places.push(place);
        }
        places
    }
}

/// ± a value.
pub(super) fn signed(program: &mut Program, sign: i8, value: Id) -> Id {
    if sign < 0 { program.neg(value) } else { value }
}
