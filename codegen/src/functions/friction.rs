//! The contacts that slide in a closed form. Without friction the accelerations would be a⁰ and the
//! reactions N⁰; a unit of the friction force R_j adds aʲ and nʲ. With `R_j = −σ_j μ_j N_j`
//!
//! ```text
//! Σ_j (δ_ij + n_i^j σ_j μ_j) N_j = N⁰_i,    a = a⁰ + Σ_j aʲ R_j
//! ```
//!
//! solved by Cramer's rule for one contact or two. The determinant vanishes at the border of
//! Painlevé's paradox and nowhere else (Génot and Brogliato, *New results on Painlevé paradoxes*,
//! Eur. J. Mech. A 18, 1999).

use crate::algebra::{Quotient, Symbol};
use crate::motion::Motion;
use crate::phases::{Phase, Sliding};
use crate::program::{Factored, Id, Lowering, Program};
use crate::system::System;

/// The motion of a phase in which contacts slide.
pub(super) struct WithFriction {
    /// Accelerations of the kept rates.
    pub accelerations: Vec<Id>,
    /// N and R of each sliding contact.
    pub forces: Vec<[Id; 2]>,
}

impl WithFriction {
    pub(super) fn lower(program: &mut Program, system: &System, phase: &Phase) -> Self {
        let every = phase.mass.iter().flatten().chain(&phase.forces).chain(&phase.velocity_terms);
        let normals: Vec<&Quotient> =
            phase.sliding.iter().map(|sliding| phase.reaction(sliding.contact)).collect();
        let every = every.chain(normals.iter().copied()).map(Quotient::numerator);
        let mut lowering = Lowering::new(program, system, &phase.opaque_terms, every);
        let zero = lowering.program().integer(0);
        for sliding in &phase.sliding {
            lowering.define(Symbol::reaction(sliding.row), zero);
        }
        let inertia = FactoredInertia::lower(&mut lowering, phase);
        let free = inertia.accelerations(&mut lowering, |k| &phase.forces[k] - &phase.velocity_terms[k]);
        let units: Vec<Vec<Id>> = phase
            .sliding
            .iter()
            .map(|s| {
                inertia.accelerations(&mut lowering, |k| phase.forces[k].derivative(Symbol::reaction(s.row)))
            })
            .collect();
        for (&i, &a) in phase.moving.iter().zip(&free) {
            lowering.define(Symbol::acceleration(i), a);
        }
        let loads: Vec<Id> = normals.iter().map(|normal| lowering.quotient(normal)).collect();
        let slopes: Vec<Id> = phase.sliding.iter().map(|s| lowering.rubbing(s)).collect();
        let gains = grid(&mut lowering, phase, &normals, &units);
        let reactions = reactions(lowering.program(), &gains, &slopes, &loads);
        let program = lowering.program();
        let forces = reactions.iter().zip(&slopes).map(|(&n, &slope)| {
            let against = program.neg(slope);
            [n, program.mul(against, n)]
        });
        let forces: Vec<[Id; 2]> = forces.collect();
        let accelerations = (0..free.len()).map(|k| {
            let added = forces.iter().zip(&units);
            added.fold(free[k], |sum, ([_, friction], unit)| program.mul_add(unit[k], *friction, sum))
        });
        Self { accelerations: accelerations.collect(), forces }
    }

    /// Names its forces after their contacts.
    pub(super) fn name(&self, program: &mut Program, motion: &Motion, system: &System, phase: &Phase) {
        for ([normal, friction], sliding) in self.forces.iter().zip(&phase.sliding) {
            let label = motion.contacts[sliding.contact].word(system).to_lowercase();
            program.set_name(*normal, || format!("reaction_{label}"));
            program.set_name(*friction, || format!("friction_{label}"));
        }
    }
}

impl Lowering<'_> {
    /// σμ of a contact that slides.
    fn rubbing(&mut self, sliding: &Sliding) -> Id {
        let (mu, sense) =
            (self.quotient(&sliding.kinetic), self.symbol(Symbol::Sense(sliding.contact as u16)));
        self.program().mul(sense, mu)
    }
}

/// n_i^j: what a unit of R_j adds to N_i.
fn grid(lowering: &mut Lowering, phase: &Phase, normals: &[&Quotient], units: &[Vec<Id>]) -> Vec<Vec<Id>> {
    let gain = |lowering: &mut Lowering, normal: &Quotient, sliding: &Sliding, unit: &[Id]| {
        let own = lowering.quotient(&normal.derivative(Symbol::reaction(sliding.row)));
        phase.moving.iter().zip(unit).fold(own, |sum, (&i, &a)| {
            let slope = lowering.quotient(&normal.derivative(Symbol::acceleration(i)));
            lowering.program().mul_add(slope, a, sum)
        })
    };
    let row = |normal: &&Quotient| {
        let columns = phase.sliding.iter().zip(units);
        columns.map(|(sliding, unit)| gain(lowering, normal, sliding, unit)).collect()
    };
    normals.iter().map(row).collect()
}

/// N of `(1 + n σμ) N = N⁰`.
fn reactions(program: &mut Program, gains: &[Vec<Id>], slopes: &[Id], loads: &[Id]) -> Vec<Id> {
    let one = program.integer(1);
    let entry = |program: &mut Program, i: usize, j: usize| {
        let product = program.mul(gains[i][j], slopes[j]);
        if i == j { program.add(one, product) } else { product }
    };
    match loads {
        [load] => {
            let whole = entry(program, 0, 0);
            vec![program.div(*load, whole)]
        }
        [first, second] => {
            let [a, b, c, d] = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| entry(program, i, j));
            let mut determinant = |a: Id, d: Id, b: Id, c: Id| {
                let product = program.mul(b, c);
                let minus = program.neg(product);
                program.mul_add(a, d, minus)
            };
            let whole = determinant(a, d, b, c);
            let above = [determinant(*first, d, b, *second), determinant(a, *second, *first, c)];
            let inverse = program.div(one, whole);
            above.map(|above| program.mul(above, inverse)).to_vec()
        }
        _ => Vec::new(),
    }
}

/// M̂, ready to be solved with.
enum FactoredInertia {
    Single(Id),
    Factored(Factored),
}

impl FactoredInertia {
    fn lower(lowering: &mut Lowering, phase: &Phase) -> Self {
        let entry = |lowering: &mut Lowering, k: usize, l: usize| lowering.quotient(&phase.mass[k][l]);
        if phase.moving.len() == 1 {
            return Self::Single(entry(lowering, 0, 0));
        }
        let rows = (0..phase.moving.len()).map(|k| (0..=k).map(|l| entry(lowering, k, l)).collect());
        let mass: Vec<Vec<Id>> = rows.collect();
        Self::Factored(Factored::factor(lowering.program(), &mass))
    }

    fn accelerations(&self, lowering: &mut Lowering, force: impl Fn(usize) -> Quotient) -> Vec<Id> {
        match self {
            Self::Single(mass) => {
                let force = lowering.quotient(&force(0));
                vec![lowering.program().div(force, *mass)]
            }
            Self::Factored(factored) => {
                let count = factored.pivots.len();
                let force: Vec<Id> = (0..count).map(|k| lowering.quotient(&force(k))).collect();
                factored.solve(lowering.program(), &force)
            }
        }
    }
}
