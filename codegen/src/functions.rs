//! Every function of a model as outputs of one program.

use crate::algebra::{Quotient, Rational, Series, Symbol};
use crate::kinematics::Kinematics;
use crate::motion::Motion;
use crate::phases::{Phase, Value};
use crate::program::{Id, Lowering, Program, solve_symmetric};
use crate::system::System;

/// Larger systems are solved by the runtime's loops, not by unrolled statements.
pub const UNROLLED: usize = 16;

/// The full equations: the runtime's `Kernel`.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// M, lower triangle.
    pub mass: Vec<Vec<Id>>,
    /// f = Q − h.
    pub force: Vec<Id>,
    /// g of each row.
    pub gap: Vec<Id>,
    /// J.
    pub jacobian: Vec<Vec<Id>>,
    /// b.
    pub bias: Vec<Id>,
}

/// The functions of a closed form.
#[derive(Clone, Debug)]
pub struct PhaseFunctions {
    /// The closed contacts.
    pub set: u64,
    /// The coordinates of the reduced state.
    pub kept: Vec<usize>,
    /// Rates of the kept coordinates.
    pub rates: Vec<Id>,
    /// Accelerations of the kept coordinates.
    pub accelerations: Vec<Id>,
    /// Reaction of each contact, zero where open; reads the accelerations of the kept coordinates.
    pub reactions: Vec<Id>,
    /// Every coordinate, then every rate.
    pub embedding: Vec<Id>,
    /// Pivots relative to the largest values they can have.
    pub pivots: Vec<Id>,
    /// T and V.
    pub energy: [Id; 2],
}

/// The functions of a model.
#[derive(Clone, Debug)]
pub struct Functions {
    /// Their common program.
    pub program: Program,
    /// The full equations.
    pub kernel: Kernel,
    /// T and V at a full state.
    pub energy: [Id; 2],
    /// x and y of each point.
    pub points: Vec<Id>,
    /// Distances of each foot from its bar's ends.
    pub feet: Vec<Id>,
    /// The closed forms.
    pub phases: Vec<PhaseFunctions>,
    /// The nominal figure: x and y of each point.
    pub figure: Vec<Id>,
}

impl Functions {
    /// Lowers everything that the model's implementation needs.
    pub fn of(system: &System, kinematics: &Kinematics, motion: &Motion, phases: &[Phase]) -> Self {
        let names = kinematics.coordinates.iter().map(|c| c.name.clone());
        let mut program = Program::new(names.collect());
        let mut all = |series: Vec<&Series>| {
            let mut lowering = Lowering::new(&mut program, system, series.iter().copied());
            series.iter().map(|s| lowering.series(s)).collect::<Vec<Id>>()
        };
        let figure = all(system.figure.iter().flatten().collect());
        let points = all(kinematics.points.iter().flatten().collect());
        let feet = all(motion
            .contacts
            .iter()
            .filter_map(|c| c.foot.as_ref())
            .flat_map(|f| [&f.from_first, &f.from_last])
            .collect());
        let kernel = kernel(&mut program, system, kinematics, motion);
        let energy = energy(&mut program, system, motion);
        let phases = phases
            .iter()
            .filter(|phase| phase.kept.len() <= UNROLLED)
            .map(|phase| phase_functions(&mut program, system, kinematics, motion, phase))
            .collect();
        Self { program, kernel, energy, points, feet, phases, figure }
    }
}

fn kernel(program: &mut Program, system: &System, kinematics: &Kinematics, motion: &Motion) -> Kernel {
    let n = motion.n;
    let forces: Vec<Series> = (0..n).map(|i| motion.force(i)).collect();
    let rows = motion.rows.iter().flat_map(|r| r.jacobian.iter().chain([&r.gap, &r.bias]));
    let every = motion.mass.iter().flatten().chain(&forces).chain(rows);
    let mut lowering = Lowering::new(program, system, every);
    let name = |i: usize| &kinematics.coordinates[i].name;
    let mut mass = Vec::new();
    for i in 0..n {
        mass.push((0..=i).map(|j| lowering.series(&motion.mass[i][j])).collect::<Vec<Id>>());
        for (j, &id) in mass[i].iter().enumerate() {
            lowering.program().set_name(id, || format!("m_{}_{}", name(i), name(j)));
        }
    }
    let force: Vec<Id> = forces.iter().map(|f| lowering.series(f)).collect();
    for (i, &id) in force.iter().enumerate() {
        lowering.program().set_name(id, || format!("f_{}", name(i)));
    }
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
    }
}

/// `T = Σ ½ m (ẋ² + ẏ²) + ½ I ω²`, a sum of squares.
fn energy(program: &mut Program, system: &System, motion: &Motion) -> [Id; 2] {
    let rates: Vec<[Series; 3]> = motion
        .inertias
        .iter()
        .map(|body| [body.centre[0].rate(), body.centre[1].rate(), body.spin.clone()])
        .collect();
    let every = rates.iter().flatten().chain([&motion.potential]);
    let mut lowering = Lowering::new(program, system, every);
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

fn phase_functions(
    program: &mut Program,
    system: &System,
    kinematics: &Kinematics,
    motion: &Motion,
    phase: &Phase,
) -> PhaseFunctions {
    let accelerations = accelerations(program, system, kinematics, phase);
    let reactions = reactions(program, system, motion, phase);
    let energies = [phase.kinetic.numerator(), phase.potential.numerator()];
    let mut lowering = Lowering::new(program, system, energies);
    let energy = [lowering.quotient(&phase.kinetic), lowering.quotient(&phase.potential)];
    let mut lowering = Lowering::new(program, system, []);
    let coordinates = phase.coordinates.iter().map(|value| match value {
        Value::Length(quotient) => lowering.quotient(quotient),
        Value::Angle(angle) => lowering.angle(angle),
    });
    let mut embedding: Vec<Id> = coordinates.collect();
    embedding.extend(phase.rates.iter().map(|rate| lowering.quotient(rate)));
    let pivots = phase.pivots.iter().map(|pivot| relative(&mut lowering, pivot)).collect();
    let rates = phase.kept.iter().map(|&i| lowering.symbol(Symbol::rate(i))).collect();
    let (set, kept) = (phase.set, phase.kept.clone());
    PhaseFunctions { set, kept, rates, accelerations, reactions, embedding, pivots, energy }
}

fn accelerations(program: &mut Program, system: &System, kinematics: &Kinematics, phase: &Phase) -> Vec<Id> {
    let n = phase.kept.len();
    let forces: Vec<Quotient> = phase.forces.iter().zip(&phase.velocity_terms).map(|(q, h)| q - h).collect();
    let every = phase.mass.iter().flatten().chain(&forces);
    let mut lowering = Lowering::new(program, system, every.map(Quotient::numerator));
    let name = |k: usize| &kinematics.coordinates[phase.kept[k]].name;
    let accelerations = if n == 1 {
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
        solve_symmetric(lowering.program(), &mass, &force)
    };
    for (k, &a) in accelerations.iter().enumerate() {
        lowering.program().set_name(a, || format!("{}_acceleration", name(k)));
    }
    accelerations
}

/// Reactions in terms of the kept coordinates, rates and accelerations.
fn reactions(program: &mut Program, system: &System, motion: &Motion, phase: &Phase) -> Vec<Id> {
    let contacts = motion.contacts.len();
    let closed = || phase.reactions.iter().filter(|(row, _)| *row < contacts);
    let mut lowering = Lowering::new(program, system, closed().map(|(_, r)| r.numerator()));
    let mut reactions = vec![lowering.program().integer(0); contacts];
    for (row, reaction) in closed() {
        reactions[*row] = lowering.quotient(reaction);
        let label = motion.contacts[*row].label(system).replace(", ", "_").to_lowercase();
        lowering.program().set_name(reactions[*row], || format!("reaction_{label}"));
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
