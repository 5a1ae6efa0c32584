//! The functions of one closed form.

use super::friction::WithFriction;
use super::{Chain, PhaseFunctions, recursion};
use crate::algebra::{Quotient, Series, Symbol};
use crate::kinematics::Kinematics;
use crate::motion::Motion;
use crate::phases::{CoordinateValue, Phase};
use crate::program::{Id, Lowering, Program, solve_symmetric};
use crate::system::System;

pub(super) fn functions(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    phase: &Phase,
) -> PhaseFunctions {
    let rubbed = (!phase.sliding.is_empty()).then(|| WithFriction::lower(program, system, phase));
    let Accelerations { values: accelerations, reduced } = match &rubbed {
        None => accelerations(program, system, kinematics, motion, phase),
        Some(rubbed) => Accelerations { values: rubbed.accelerations.clone(), reduced: None },
    };
    name(program, kinematics, phase, &accelerations);
    if let Some(rubbed) = &rubbed {
        rubbed.name(program, motion, system, phase);
    }
    let reactions = reactions(program, system, motion, phase, (rubbed.as_ref(), reduced.as_ref()));
    let energies = [phase.kinetic.numerator(), phase.potential.numerator()];
    let mut lowering = Lowering::new(program, system, &phase.opaque_terms, energies);
    let energy = [lowering.quotient(&phase.kinetic), lowering.quotient(&phase.potential)];
    let mut lowering = Lowering::new(program, system, &phase.opaque_terms, []);
    let coordinates = phase.coordinates.iter().map(|value| match value {
        CoordinateValue::Length(quotient) | CoordinateValue::Rate(quotient) => lowering.quotient(quotient),
        CoordinateValue::Angle(angle) => lowering.angle(angle),
    });
    let mut embedding: Vec<Id> = coordinates.collect();
    embedding.extend(phase.rates.iter().map(|rate| lowering.quotient(rate)));
    let pivots = phase.pivots.iter().map(|pivot| relative(&mut lowering, pivot)).collect();
    let rates = phase.kept.iter().map(|&i| lowering.quotient(&phase.rates[i])).collect();
    let chain = Chain::recognise(&mut lowering, system, kinematics, motion);
    let (set, kept, moving) = (phase.set, phase.kept.clone(), phase.moving.clone());
    PhaseFunctions { set, kept, moving, rates, accelerations, chain, reactions, embedding, pivots, energy }
}

/// The accelerations of the kept rates.
struct Accelerations {
    values: Vec<Id>,
    reduced: Option<Reduced>,
}

/// A single acceleration a = w b, where w are sines and cosines that its force has as factors:
/// reactions that divide a by them are polynomials in b.
struct Reduced {
    waves: Quotient,
    value: Id,
}

fn accelerations(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    phase: &Phase,
) -> Accelerations {
    let n = phase.moving.len();
    let forces: Vec<Quotient> = phase.forces.iter().zip(&phase.velocity_terms).map(|(q, h)| q - h).collect();
    let every = phase.mass.iter().flatten().chain(&forces);
    let mut lowering = Lowering::new(program, system, &phase.opaque_terms, every.map(Quotient::numerator));
    let name = |k: usize| &kinematics.coordinates[phase.moving[k]].name;
    let mut solutions = Vec::new();
    for Scaled { mass, forces, units } in Scaled::each(&phase.mass, &forces) {
        let mut waves = None;
        let solution = if n == 1 {
            let (factors, _) = forces[0].numerator().split_waves();
            let product = factors.iter().fold(Series::one(), |product, (wave, k)| product * wave.pow(*k));
            let product = Quotient::from(product);
            let reduced = lowering.ratio(&(&forces[0] / &product), &mass[0][0]);
            waves = Some(product);
            vec![reduced]
        } else {
            let mass: Vec<Vec<Id>> =
                (0..n).map(|k| (0..=k).map(|l| lowering.quotient(&mass[k][l])).collect()).collect();
            let forces: Vec<Id> = forces.iter().map(|force| lowering.quotient(force)).collect();
            for k in 0..n {
                for (l, &id) in mass[k].iter().enumerate() {
                    lowering.program().set_name(id, || format!("m_{}_{}", name(k), name(l)));
                }
                lowering.program().set_name(forces[k], || format!("f_{}", name(k)));
            }
            solve_symmetric(lowering.program(), &mass, &forces)
        };
        let scaled = solution.into_iter().zip(&units).map(|(a, unit)| {
            let unit = lowering.quotient(unit);
            lowering.program().div(a, unit)
        });
        let mut values = scaled.collect::<Vec<Id>>();
        let reduced = waves.map(|waves| Reduced { value: values[0], waves });
        if let Some(Reduced { waves, value }) = &reduced {
            let waves = lowering.quotient(waves);
            values = vec![lowering.program().mul(*value, waves)];
        }
        solutions.push(Accelerations { values, reduced });
    }
    let tree = motion
        .tree
        .as_ref()
        .filter(|_| n > 1 && phase.set.closed == 0 && n == motion.n && phase.eliminated.is_empty());
    solutions.extend(tree.map(|tree| {
        let values = recursion(lowering.program(), system, kinematics, motion, tree, &[]).swap_remove(0);
        Accelerations { values, reduced: None }
    }));
    let program = &*lowering.program();
    let cost = |a: &Accelerations| {
        let cost = program.cost(&a.values);
        (program.cycles(&a.values), cost.weight(), cost.flops())
    };
    solutions.into_iter().min_by_key(cost).unwrap_or(Accelerations { values: Vec::new(), reduced: None })
}

/// M a = f with a in other units: a′ᵢ = uᵢ aᵢ, M′ᵢⱼ = Mᵢⱼ / (c uᵢ uⱼ), f′ᵢ = fᵢ / (c uᵢ), where c
/// and uᵢ are products of parameters.
struct Scaled {
    mass: Vec<Vec<Quotient>>,
    forces: Vec<Quotient>,
    units: Vec<Quotient>,
}

impl Scaled {
    /// As it stands; over what all masses have in common; and with that unit of each coordinate
    /// that its own mass has squared.
    fn each(mass: &[Vec<Quotient>], forces: &[Quotient]) -> Vec<Self> {
        let n = forces.len();
        let one = || Quotient::from(Series::one());
        let content = |series: &Series| {
            let (number, monomial) = series.content();
            Quotient::from(Series::monomial(number, monomial.split_units().0))
        };
        let plain = Self { mass: mass.to_vec(), forces: forces.to_vec(), units: vec![one(); n] };
        if n == 0 {
            return vec![plain];
        }
        let diagonal = (0..n).map(|i| content(mass[i][i].numerator()).numerator().clone());
        let common = content(&diagonal.clone().sum());
        let own: Vec<Quotient> = diagonal.map(|mass| root(&(Quotient::from(mass) / &common))).collect();
        let scaled = |units: Vec<Quotient>| {
            let entry = |i: usize, j: usize| &mass[i][j] / &(&common * &(&units[i] * &units[j]));
            Self {
                mass: (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect(),
                forces: (0..n).map(|i| &forces[i] / &(&common * &units[i])).collect(),
                units,
            }
        };
        vec![scaled(vec![one(); n]), scaled(own), plain]
    }
}

/// The greatest product of parameters whose square divides a product of parameters.
fn root(product: &Quotient) -> Quotient {
    let powers = product.numerator().as_monomial().map(|(_, monomial)| monomial.factors().to_vec());
    let factors =
        powers.into_iter().flatten().map(|(symbol, k)| Series::symbol(symbol).pow((k.max(0) / 2) as u32));
    Quotient::from(factors.fold(Series::one(), |product, factor| product * factor))
}

fn name(program: &mut Program, kinematics: &Kinematics, phase: &Phase, accelerations: &[Id]) {
    for (&i, &a) in phase.moving.iter().zip(accelerations) {
        program.set_name(a, || format!("{}_acceleration", kinematics.coordinates[i].name));
    }
}

impl Reduced {
    /// A reaction in terms of b, in place of a, where fewer factors are left below it.
    fn substitute(&self, reaction: &Quotient, phase: &Phase) -> Option<(Quotient, Symbol, Id)> {
        let acceleration = Symbol::acceleration(phase.moving[0]);
        let product = &self.waves * &Quotient::from(Series::symbol(acceleration));
        let substituted = reaction.substitute_quotient(acceleration, &product);
        let count = |quotient: &Quotient| quotient.factors().iter().map(|(_, k)| k).sum::<u32>();
        (count(&substituted) < count(reaction)).then_some((substituted, acceleration, self.value))
    }
}

/// Reactions in terms of the kept coordinates, rates and accelerations, then the friction forces.
fn reactions(
    program: &mut Program,
    system: &System,
    motion: &Motion,
    phase: &Phase,
    (rubbed, reduced): (Option<&WithFriction>, Option<&Reduced>),
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
        let value = match reduced.and_then(|reduced| reduced.substitute(reaction, phase)) {
            None => lowering.quotient(reaction),
            Some((reaction, acceleration, value)) => {
                lowering.define(acceleration, value);
                let reaction = lowering.quotient(&reaction);
                let whole = lowering.program().input(acceleration);
                lowering.define(acceleration, whole);
                reaction
            }
        };
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
