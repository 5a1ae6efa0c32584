//! The functions of a long tree.

use super::tree::{Inverse, TreeGeometry, energy, joints, momenta, paths, points, recursion};
use super::{Chain, Functions, Mass, PhaseFunctions, full, kinks};
use crate::kinematics::Kinematics;
use crate::motion::{Motion, Tree};
use crate::program::{Lowering, Program};
use crate::system::System;

pub(super) fn functions(system: &System, kinematics: &Kinematics, motion: &Motion, tree: &Tree) -> Functions {
    let names = kinematics.coordinates.iter().map(|c| c.name.clone());
    let mut program = Program::new(names.collect());
    let accelerations = recursion(&mut program, system, kinematics, motion, tree, &[]).swap_remove(0);
    let mut quantities = full::quantities(&mut program, system, motion);
    let mut lowering = Lowering::new(&mut program, system, &motion.opaque_terms, []);
    let geometry = TreeGeometry::lower(&mut lowering, system, kinematics, tree);
    let first = quantities.len();
    quantities.extend(joints(&mut lowering, &geometry, motion));
    let together = first..quantities.len();
    quantities.extend(momenta(&mut lowering, &geometry));
    let zero = lowering.program().integer(0);
    let inverse = Inverse::lower(&mut lowering, &geometry, &vec![zero; motion.n], &motion.loads.actions);
    let force = inverse.couples.iter().map(|&couple| lowering.program().neg(couple)).collect();
    let mass = Mass::Paths(paths(&mut lowering, &geometry));
    let kernel = full::with_rows(&mut lowering, motion, mass, force);
    let energy = energy(&mut lowering, &geometry, motion);
    let points = points(&mut lowering, &geometry);
    let slips = full::slips(lowering.program(), system, motion);
    let feet = motion.contacts.iter().filter_map(|c| c.foot.as_ref());
    let feet =
        feet.flat_map(|foot| [&foot.from_first, &foot.from_last]).map(|s| lowering.series(s)).collect();
    let figure = system.figure.iter().flatten().map(|s| lowering.series(s)).collect();
    let chain = Chain::recognise(&mut lowering, system, kinematics, motion);
    let free = PhaseFunctions::of_all(lowering.program(), motion, accelerations, energy);
    let phases = vec![PhaseFunctions { chain, ..free }];
    let kinks = kinks::kinks(&mut program, &kernel);
    Functions {
        program,
        kernel,
        energy,
        points,
        feet,
        slips,
        phases,
        held: Vec::new(),
        projected: None,
        figure,
        quantities,
        together,
        kinks,
    }
}
