//! The force of each joint on each of its bodies, and of the ground where it holds one.

use super::geometry::TreeGeometry;
use super::inverse::Inverse;
use super::vector::{add, sub};
use crate::algebra::Symbol;
use crate::motion::{Motion, Quantity, Scene};
use crate::program::{Id, Lowering};

/// `fx(D, AD)`, …, by name; nothing where supports share a reaction in an unknown way.
pub(in crate::functions) fn joints(
    lowering: &mut Lowering,
    geometry: &TreeGeometry,
    motion: &Motion,
) -> Vec<Quantity<Id>> {
    let (system, kinematics) = (geometry.system, geometry.kinematics);
    let Some(actions) = motion.actions(&Scene { system, kinematics }) else { return Vec::new() };
    let accelerations: Vec<Id> =
        (0..motion.n).map(|i| lowering.program().input(Symbol::acceleration(i))).collect();
    let forces = Inverse::lower(lowering, geometry, &accelerations, &actions).forces;
    let program = lowering.program();
    let zero = program.integer(0);
    let mut named = Vec::new();
    for (point, declared) in system.points.iter().enumerate() {
        let enters = |i: &usize| kinematics.tree.entry[geometry.tree.branches[*i].body] == point;
        let entering: Vec<usize> = (0..forces.len()).filter(enters).collect();
        let through = entering.iter().fold([zero; 2], |sum, &i| add(program, sum, forces[i]));
        let pinned = system.pins.iter().any(|pin| pin.point == point);
        let bodies = declared.on.iter().map(|(body, _)| *body).filter(|_| declared.on.len() > 1 || pinned);
        for body in bodies {
            let own = entering.iter().find(|&&i| geometry.tree.branches[i].body == body);
            let mut force = own.map_or([zero; 2], |&i| forces[i]);
            if kinematics.tree.owner[point] == Some(body) {
                force = sub(program, force, through);
            }
            let holder = format!("{}, {}", declared.name, system.bodies[body].name);
            named.extend(Quantity::joint_force(&holder, force));
        }
        if pinned {
            named.extend(Quantity::joint_force(&declared.name, through));
        }
    }
    named
}
