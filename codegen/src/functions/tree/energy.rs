//! Positions, energies and momenta of a tree.

use super::geometry::TreeGeometry;
use super::vector::{Vector, add, dot, normal, scaled_add};
use crate::algebra::{Rational, Series};
use crate::motion::{Branch, LumpedMass, Motion, Quantity};
use crate::program::{Id, Lowering};

/// A mass in motion.
struct Moving {
    mass: Id,
    inertia: Id,
    spin: Id,
    place: Vector,
    velocity: Vector,
}

fn moving(lowering: &mut Lowering, geometry: &TreeGeometry) -> Vec<Moving> {
    let places = geometry.places(lowering.program());
    let velocities = geometry.velocities(lowering.program());
    let lumped_masses = |(i, branch): (usize, &Branch)| {
        branch.lumped_masses.iter().map(|lumped| (i, lumped.clone())).collect::<Vec<_>>()
    };
    let lumped_masses = geometry.tree.branches.iter().enumerate().flat_map(lumped_masses);
    let one = |(i, lumped): (usize, LumpedMass)| {
        let arm = geometry.turned(lowering, i, &lumped.at);
        let (mass, inertia) = (lowering.series(&lumped.mass), lowering.series(&lumped.inertia));
        let program = lowering.program();
        let across = normal(program, arm);
        let velocity = scaled_add(program, geometry.spin[i], across, velocities[i]);
        Moving { mass, inertia, spin: geometry.spin[i], place: add(program, places[i], arm), velocity }
    };
    lumped_masses.map(one).collect()
}

/// `T = Σ ½ m v² + ½ I ω²` and V.
pub(in crate::functions) fn energy(
    lowering: &mut Lowering,
    geometry: &TreeGeometry,
    motion: &Motion,
) -> [Id; 2] {
    let moving = moving(lowering, geometry);
    let program = lowering.program();
    let mut twice = program.integer(0);
    for Moving { mass, inertia, spin, velocity, .. } in moving {
        for (weight, rate) in [(mass, velocity[0]), (mass, velocity[1]), (inertia, spin)] {
            let square = program.mul(rate, rate);
            twice = program.mul_add(weight, square, twice);
        }
    }
    let half = program.ratio(Rational::new(1, 2));
    [program.mul(half, twice), lowering.series(&motion.potential)]
}

/// `Σ m v` and `Σ m r × v + I ω`, by name.
pub(in crate::functions) fn momenta(lowering: &mut Lowering, geometry: &TreeGeometry) -> [Quantity<Id>; 3] {
    let moving = moving(lowering, geometry);
    let program = lowering.program();
    let [mut x, mut y, mut z] = [program.integer(0); 3];
    for Moving { mass, inertia, spin, place, velocity } in moving {
        let (across, momentum) = (normal(program, place), velocity.map(|part| program.mul(mass, part)));
        x = program.add(x, momentum[0]);
        y = program.add(y, momentum[1]);
        let orbital = dot(program, across, momentum);
        z = program.add(z, orbital);
        z = program.mul_add(inertia, spin, z);
    }
    Quantity::momenta([x, y, z])
}

/// x and y of every point.
pub(in crate::functions) fn points(lowering: &mut Lowering, geometry: &TreeGeometry) -> Vec<Id> {
    let places = geometry.places(lowering.program());
    let (system, tree) = (geometry.system, &geometry.kinematics.tree);
    let mut points = Vec::new();
    for (point, place) in geometry.kinematics.points.iter().enumerate() {
        let branch =
            tree.owner[point].and_then(|body| geometry.tree.branches.iter().position(|b| b.body == body));
        let place: Vector = match branch {
            None => place.each_ref().map(|part| lowering.series(part)),
            Some(i) => {
                let body = geometry.tree.branches[i].body;
                let (local, entry) = (system.local(body, point), system.local(body, tree.entry[body]));
                let arm: [Series; 2] = [0, 1].map(|axis| &local[axis] - &entry[axis]);
                let arm = geometry.turned(lowering, i, &arm);
                add(lowering.program(), places[i], arm)
            }
        };
        points.extend(place);
    }
    points
}
