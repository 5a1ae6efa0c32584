//! The functions of one closed form.

use super::friction::WithFriction;
use super::{Chain, PhaseFunctions, recursion};
use crate::algebra::{Quotient, Series, Symbol};
use crate::kinematics::Kinematics;
use crate::motion::Motion;
use crate::phases::{Phase, Value};
use crate::program::{Id, Lowering, Program, solve_symmetric};
use crate::system::System;

pub(super) fn functions(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    phase: &Phase,
) -> PhaseFunctions {
    let rubbed = (!phase.sliding.is_empty()).then(|| WithFriction::of(program, system, phase));
    let accelerations = match &rubbed {
        None => accelerations(program, system, kinematics, motion, phase),
        Some(rubbed) => rubbed.accelerations.clone(),
    };
    name(program, kinematics, phase, &accelerations);
    if let Some(rubbed) = &rubbed {
        rubbed.name(program, motion, system, phase);
    }
    let reactions = reactions(program, system, motion, phase, rubbed.as_ref());
    let energies = [phase.kinetic.numerator(), phase.potential.numerator()];
    let mut lowering = Lowering::new(program, system, &phase.opaque_terms, energies);
    let energy = [lowering.quotient(&phase.kinetic), lowering.quotient(&phase.potential)];
    let mut lowering = Lowering::new(program, system, &phase.opaque_terms, []);
    let coordinates = phase.coordinates.iter().map(|value| match value {
        Value::Length(quotient) | Value::Rate(quotient) => lowering.quotient(quotient),
        Value::Angle(angle) => lowering.angle(angle),
    });
    let mut embedding: Vec<Id> = coordinates.collect();
    embedding.extend(phase.rates.iter().map(|rate| lowering.quotient(rate)));
    let pivots = phase.pivots.iter().map(|pivot| relative(&mut lowering, pivot)).collect();
    let rates = phase.kept.iter().map(|&i| lowering.quotient(&phase.rates[i])).collect();
    let chain = Chain::of(&mut lowering, system, kinematics, motion);
    let (set, kept, moving) = (phase.set, phase.kept.clone(), phase.moving.clone());
    PhaseFunctions { set, kept, moving, rates, accelerations, chain, reactions, embedding, pivots, energy }
}

fn accelerations(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    phase: &Phase,
) -> Vec<Id> {
    let n = phase.moving.len();
    let forces: Vec<Quotient> = phase.forces.iter().zip(&phase.velocity_terms).map(|(q, h)| q - h).collect();
    let every = phase.mass.iter().flatten().chain(&forces);
    let mut lowering = Lowering::new(program, system, &phase.opaque_terms, every.map(Quotient::numerator));
    let name = |k: usize| &kinematics.coordinates[phase.moving[k]].name;
    if n == 1 {
        vec![lowering.ratio(&forces[0], &phase.mass[0][0])]
    } else {
        let mut mass = Vec::new();
        for k in 0..n {
            mass.push((0..=k).map(|l| lowering.quotient(&phase.mass[k][l])).collect::<Vec<Id>>());
            for (l, &id) in mass[k].iter().enumerate() {
                lowering.program().set_name(id, || format!("m_{}_{}", name(k), name(l)));
            }
        }
        let force: Vec<Id> = forces.iter().map(|f| lowering.quotient(f)).collect();
        for (k, &id) in force.iter().enumerate() {
            lowering.program().set_name(id, || format!("f_{}", name(k)));
        }
        let solved = solve_symmetric(lowering.program(), &mass, &force);
        let tree = motion
            .tree
            .as_ref()
            .filter(|_| phase.set.closed == 0 && n == motion.n && phase.eliminated.is_empty());
        let passed = tree
            .map(|tree| recursion(lowering.program(), system, kinematics, motion, tree, &[]).swap_remove(0));
        let program = &*lowering.program();
        let cost = |a: &Vec<Id>| program.cycles(a);
        passed.filter(|passed| cost(passed) < cost(&solved)).unwrap_or(solved)
    }
}

fn name(program: &mut Program, kinematics: &Kinematics, phase: &Phase, accelerations: &[Id]) {
    for (&i, &a) in phase.moving.iter().zip(accelerations) {
        program.set_name(a, || format!("{}_acceleration", kinematics.coordinates[i].name));
    }
}

/// Reactions in terms of the kept coordinates, rates and accelerations, then the friction forces.
fn reactions(
    program: &mut Program,
    system: &System,
    motion: &Motion,
    phase: &Phase,
    rubbed: Option<&WithFriction>,
) -> Vec<Id> {
    let contacts = motion.contacts.len();
    let frictions: Vec<usize> = motion.frictions().map(|(_, row)| row).collect();
    let rubs = |row: usize| frictions.iter().position(|slip| *slip == row).map(|k| contacts + k);
    let place = |row: usize| if row < contacts { Some(row) } else { rubs(row) };
    let steps = &phase.reaction_steps;
    let mut lowering =
        Lowering::new(program, system, &phase.opaque_terms, steps.iter().map(|(_, r)| r.numerator()));
    let mut reactions = vec![lowering.program().integer(0); contacts + frictions.len()];
    let forces = phase.sliding.iter().zip(rubbed.iter().flat_map(|rubbed| &rubbed.forces));
    for (sliding, [_, friction]) in forces.clone() {
        lowering.define(Symbol::reaction(sliding.row), *friction);
    }
    for (row, reaction) in steps {
        let value = lowering.quotient(reaction);
        lowering.define(Symbol::reaction(*row), value);
        let Some(place) = place(*row) else { continue };
        reactions[place] = value;
        let (kind, contact) = match place.checked_sub(contacts) {
            None => ("reaction", place),
            Some(k) => ("friction", motion.tangents[frictions[k] - motion.slips()]),
        };
        let label = motion.contacts[contact].word(system).to_lowercase();
        lowering.program().set_name(reactions[place], || format!("{kind}_{label}"));
    }
    for (sliding, [normal, friction]) in forces {
        reactions[sliding.contact] = *normal;
        if let Some(place) = rubs(sliding.row) {
            reactions[place] = *friction;
        }
    }
    reactions
}

/// A pivot over the sum of its terms' magnitudes.
fn relative(lowering: &mut Lowering, pivot: &Series) -> Id {
    let value = lowering.series(pivot);
    let mut bound = Series::zero();
    for (term, coefficient) in pivot.terms() {
        let factors = term.monomial.factors().iter().filter(|(s, _)| matches!(s, Symbol::Parameter(_)));
        bound += factors.fold(Series::constant(coefficient.abs()), |product, &(symbol, k)| {
            &product * &Series::symbol(symbol).pow(k.unsigned_abs().into())
        });
    }
    let bound = lowering.series(&bound);
    lowering.program().div(value, bound)
}
