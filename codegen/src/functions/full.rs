//! The full equations and the energies at a full state.

use super::{Kernel, Mass};
use crate::algebra::{Rational, Series, Symbol};
use crate::kinematics::Kinematics;
use crate::motion::{Dense, Motion, Products, Quantity};
use crate::program::{Id, Lowering, Program};
use crate::system::System;

pub(super) fn kernel(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    dense: &Dense,
) -> Kernel {
    let n = motion.n;
    let forces: Vec<Series> = (0..n).map(|i| dense.force(i)).collect();
    let rows =
        motion.rows.iter().flat_map(|r| r.jacobian.iter().chain([&r.gap, &r.bias, &r.prescribed_gap_rate]));
    let every = dense.mass.iter().flatten().chain(&forces).chain(rows);
    let mut lowering = Lowering::new(program, system, &motion.opaque_terms, every);
    let name = |i: usize| &kinematics.coordinates[i].name;
    let mut mass = Vec::new();
    for i in 0..n {
        mass.push((0..=i).map(|j| lowering.series(&dense.mass[i][j])).collect::<Vec<Id>>());
        for (j, &id) in mass[i].iter().enumerate() {
            lowering.program().set_name(id, || format!("m_{}_{}", name(i), name(j)));
        }
    }
    let force: Vec<Id> = forces.iter().map(|f| lowering.series(f)).collect();
    for (i, &id) in force.iter().enumerate() {
        lowering.program().set_name(id, || format!("f_{}", name(i)));
    }
    with_rows(&mut lowering, motion, Mass::Entries(mass), force)
}

/// The kernel with its rows of contacts and joints.
pub(super) fn with_rows(lowering: &mut Lowering, motion: &Motion, mass: Mass, force: Vec<Id>) -> Kernel {
    Kernel {
        mass,
        force,
        gap: motion.rows.iter().map(|r| lowering.series(&r.gap)).collect(),
        jacobian: motion
            .rows
            .iter()
            .map(|r| r.jacobian.iter().map(|j| lowering.series(j)).collect())
            .collect(),
        bias: motion.rows.iter().map(|r| lowering.series(&r.bias)).collect(),
        prescribed_gap_rate: motion.rows.iter().map(|r| lowering.series(&r.prescribed_gap_rate)).collect(),
        friction: friction(lowering, motion),
    }
}

/// σμ of each row.
fn friction(lowering: &mut Lowering, motion: &Motion) -> Vec<Id> {
    let mut friction = vec![lowering.program().integer(0); motion.rows.len()];
    for (contact, row) in motion.frictions() {
        let law = motion.contacts[contact].friction.as_ref();
        let kinetic = law.map(|law| lowering.series(&law.kinetic));
        let sense = lowering.symbol(Symbol::Sense(contact as u16));
        friction[row] = kinetic.map_or(sense, |kinetic| lowering.program().mul(sense, kinetic));
    }
    friction
}

/// v, μ and μₛ of each contact with friction.
pub(super) fn slips(program: &mut Program, system: &System, motion: &Motion) -> Vec<[Id; 3]> {
    let mut lowering = Lowering::new(program, system, &motion.opaque_terms, []);
    let frictions = motion.frictions().filter_map(|(contact, row)| {
        let law = motion.contacts[contact].friction.as_ref()?;
        Some([&motion.rows[row].velocity(), &law.kinetic, &law.limit].map(|series| lowering.series(series)))
    });
    frictions.collect()
}

/// `T = Σ ½ m (ẋ² + ẏ²) + ½ I ω²`, a sum of squares.
pub(super) fn energy(program: &mut Program, system: &System, motion: &Motion) -> [Id; 2] {
    let rates: Vec<[Series; 3]> = motion
        .inertias
        .iter()
        .map(|body| [body.centre[0].rate(), body.centre[1].rate(), body.spin.clone()])
        .collect();
    let every = rates.iter().flatten().chain([&motion.potential]);
    let mut lowering = Lowering::new(program, system, &motion.opaque_terms, every);
    let mut twice = lowering.program().integer(0);
    for (body, [x, y, spin]) in motion.inertias.iter().zip(&rates) {
        let (m, i) = (lowering.series(&body.mass), lowering.series(&body.inertia));
        for (weight, rate) in [(m, x), (m, y), (i, spin)] {
            let rate = lowering.series(rate);
            let square = lowering.program().mul(rate, rate);
            twice = lowering.program().mul_add(weight, square, twice);
        }
    }
    let half = lowering.program().ratio(Rational::new(1, 2));
    let kinetic = lowering.program().mul(half, twice);
    [kinetic, lowering.series(&motion.potential)]
}

/// `Σ a b` of each; what is the opposite of an earlier one is that with a minus.
pub(super) fn quantities(program: &mut Program, system: &System, motion: &Motion) -> Vec<Quantity<Id>> {
    let every = motion.quantities.iter().flat_map(|quantity| quantity.value.iter().flatten());
    let mut lowering = Lowering::new(program, system, &motion.opaque_terms, every);
    let mut ids: Vec<Quantity<Id>> = Vec::new();
    for Quantity { name, kind, value: products } in &motion.quantities {
        let opposite =
            motion.quantities[..ids.len()].iter().position(|other| are_opposite(products, &other.value));
        let id = match opposite {
            Some(other) => lowering.program().neg(ids[other].value),
            None => {
                let factors = products.iter().filter(|[a, b]| !a.is_zero() && !b.is_zero());
                let factors: Vec<_> =
                    factors.map(|[a, b]| (lowering.series(a), lowering.series(b))).collect();
                lowering.program().dot(factors)
            }
        };
        ids.push(Quantity::new(name.clone(), *kind, id));
    }
    ids
}

fn are_opposite(a: &Products, b: &Products) -> bool {
    match (&a[..], &b[..]) {
        ([[one, a]], [[other, b]]) => one == other && a.len() == b.len() && *a == -b,
        _ => false,
    }
}
