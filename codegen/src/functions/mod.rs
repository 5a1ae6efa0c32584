//! Every function of a model as outputs of one program.

mod affine;
mod chain;
mod constant_names;
mod friction;
mod full;
mod held;
mod kinks;
mod long;
mod phase;
mod phase_names;
mod scope;
mod tree;

use core::ops::Range;

use crate::algebra::{Series, Symbol};
use crate::kinematics::Kinematics;
use crate::motion::{ClosedSet, Dense, Motion, Quantity, Tree, UNROLLED};
use crate::phases::Phase;
use crate::program::{Id, Lowering, Program};
use crate::system::System;
pub use chain::Chain;
pub(crate) use constant_names::constant_names;
pub use held::{HeldMotion, HeldSolution};
pub use kinks::Kink;
pub(crate) use phase_names::phase_names;
pub use scope::{SeriesOutputs, SeriesScope};
pub use tree::{Paths, recursion};

/// The full equations: the runtime's `Kernel`.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// M.
    pub mass: Mass,
    /// f = Q − h.
    pub force: Vec<Id>,
    /// g of each row.
    pub gap: Vec<Id>,
    /// J.
    pub jacobian: Vec<Vec<Id>>,
    /// b.
    pub bias: Vec<Id>,
    /// ∂g/∂t.
    pub prescribed_gap_rate: Vec<Id>,
    /// σμ of the slips of contacts with friction, zero of other rows.
    pub friction: Vec<Id>,
}

/// A mass matrix.
#[derive(Clone, Debug)]
pub enum Mass {
    /// Its lower triangle.
    Entries(Vec<Vec<Id>>),
    /// That of a tree, by paths.
    Paths(Paths),
}

impl Kernel {
    /// All that it is computed from.
    pub fn outputs(&self) -> Vec<Id> {
        let Self { mass, force, gap, jacobian, bias, prescribed_gap_rate: drift, friction } = self;
        let rows = gap.iter().chain(jacobian.iter().flatten()).chain(bias).chain(drift).chain(friction);
        mass.outputs().iter().chain(force).chain(rows).copied().collect()
    }
}

impl Mass {
    /// All entries row by row, or what the paths are computed from.
    pub fn written(&self, n: usize) -> Vec<Id> {
        match self {
            Self::Entries(rows) => (0..n * n).map(|k| rows[(k / n).max(k % n)][(k / n).min(k % n)]).collect(),
            Self::Paths(_) => self.outputs(),
        }
    }

    /// What it is computed from.
    pub fn outputs(&self) -> Vec<Id> {
        match self {
            Self::Entries(rows) => rows.iter().flatten().copied().collect(),
            Self::Paths(Paths { reach, moments, own, .. }) => {
                reach.iter().chain(moments).flatten().chain(own).copied().collect()
            }
        }
    }
}

/// The functions of a closed form.
#[derive(Clone, Debug)]
pub struct PhaseFunctions {
    /// The closed contacts.
    pub set: ClosedSet,
    /// The coordinates of the reduced state.
    pub kept: Vec<usize>,
    /// Those of them whose rates it has.
    pub moving: Vec<usize>,
    /// Rates of the kept coordinates.
    pub rates: Vec<Id>,
    /// Accelerations of the kept rates.
    pub accelerations: Vec<Id>,
    /// Where loops over equal bars give the accelerations.
    pub chain: Option<Chain>,
    /// Reaction of each contact, zero where open, then the friction forces; reads the accelerations
    /// of the kept rates.
    pub reactions: Vec<Id>,
    /// Every coordinate, then every rate.
    pub embedding: Vec<Id>,
    /// Pivots relative to the largest values they can have.
    pub pivots: Vec<Id>,
    /// T and V.
    pub energy: [Id; 2],
}

impl PhaseFunctions {
    /// Those of all coordinates, without closed contacts.
    fn of_all(program: &mut Program, motion: &Motion, accelerations: Vec<Id>, energy: [Id; 2]) -> Self {
        let all: Vec<usize> = (0..motion.n).collect();
        let rates: Vec<Id> = all.iter().map(|&i| program.input(Symbol::rate(i))).collect();
        let coordinates: Vec<Id> = all.iter().map(|&i| program.input(Symbol::coordinate(i))).collect();
        let reactions = vec![program.integer(0); motion.reactions()];
        Self {
            set: ClosedSet::default(),
            kept: all.clone(),
            moving: all,
            embedding: [coordinates, rates.clone()].concat(),
            rates,
            accelerations,
            chain: None,
            reactions,
            pivots: Vec::new(),
            energy,
        }
    }
}

/// Whether no contact or a single one leaves a phase without a closed form, whose series are those
/// of the full equations.
fn needs_projected_series(motion: &Motion, phases: &[PhaseFunctions]) -> bool {
    let sets = core::iter::once(0).chain((0..motion.contacts.len().min(64)).map(|i| 1 << i));
    let has_form = |closed: u64| phases.iter().any(|phase| phase.set.closed == closed);
    motion.n <= UNROLLED && !motion.has_hinges() && !sets.into_iter().all(has_form)
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
    /// v, μ and μₛ of each contact with friction.
    pub slips: Vec<[Id; 3]>,
    /// The closed forms.
    pub phases: Vec<PhaseFunctions>,
    /// Motions that joints and contacts hold, without a closed form.
    pub held: Vec<HeldMotion>,
    /// The full state as a phase, for the Taylor series of the full equations, where phases need
    /// them.
    pub projected: Option<PhaseFunctions>,
    /// The nominal figure: x and y of each point.
    pub figure: Vec<Id>,
    /// Forces, couples and momenta by name; they read the accelerations of all coordinates and the
    /// multipliers of all rows.
    pub quantities: Vec<Quantity<Id>>,
    /// Those of them that are computed together: the forces of the joints of a tree.
    pub together: Range<usize>,
    /// Where the equations are not analytic.
    pub kinks: Vec<Kink>,
}

impl Functions {
    /// Lowers everything that the model's implementation needs.
    pub fn lower(
        system: &System,
        kinematics: &Kinematics,
        motion: &Motion,
        dense: &Dense,
        phases: &[Phase],
    ) -> Self {
        let names = kinematics.coordinates.iter().map(|c| c.name.clone());
        let mut program = Program::new(names.collect());
        let mut all = |series: Vec<&Series>| {
            let mut lowering =
                Lowering::new(&mut program, system, &motion.opaque_terms, series.iter().copied());
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
        let quantities = full::quantities(&mut program, system, motion);
        let kernel = full::kernel(&mut program, system, kinematics, motion, dense);
        let energy = full::energy(&mut program, system, motion);
        let slips = full::slips(&mut program, system, motion);
        let phases: Vec<PhaseFunctions> = phases
            .iter()
            .filter(|phase| phase.moving.len() <= UNROLLED)
            .map(|phase| phase::functions(&mut program, system, kinematics, motion, phase))
            .collect();
        let held = held::held_motions(&mut program, system, kinematics, motion, &kernel, &phases);
        let projected = needs_projected_series(motion, &phases)
            .then(|| PhaseFunctions::of_all(&mut program, motion, Vec::new(), energy));
        let kinks = kinks::kinks(&mut program, &kernel);
        Self {
            program,
            kernel,
            energy,
            points,
            feet,
            slips,
            phases,
            held,
            projected,
            figure,
            quantities,
            together: 0..0,
            kinks,
        }
    }

    /// The entries of M and of J that vary, row and column of each.
    pub fn varying(&self) -> [Vec<[usize; 2]>; 2] {
        let Kernel { mass, force, jacobian, .. } = &self.kernel;
        let mass: Vec<Vec<Id>> =
            mass.written(force.len()).chunks(force.len().max(1)).map(<[Id]>::to_vec).collect();
        [&mass, jacobian].map(|rows| {
            let entries = (0..).zip(rows).flat_map(|(i, row)| (0..).zip(row).map(move |(j, &id)| (i, j, id)));
            let varying = entries.filter(|&(.., id)| !self.program.is_constant(id));
            varying.map(|(i, j, _)| [i, j]).collect()
        })
    }

    /// The same for a long tree, each function by a recursion over its bodies.
    pub fn of_tree(system: &System, kinematics: &Kinematics, motion: &Motion, tree: &Tree) -> Self {
        long::functions(system, kinematics, motion, tree)
    }

    /// Every output that the constants are collected for.
    pub fn outputs(&self) -> Vec<Id> {
        let kernel = self.kernel.outputs();
        let loops: Vec<Id> = self.phases.iter().filter_map(|p| p.chain).flat_map(|c| c.constants()).collect();
        let phases = self.phases.iter().flat_map(|phase| {
            let motion = phase.rates.iter().chain(&phase.accelerations).chain(&phase.reactions);
            motion.chain(&phase.embedding).chain(&phase.pivots).chain(&phase.energy)
        });
        let held = self.held.iter().flat_map(|HeldMotion { solution, .. }| {
            let HeldSolution { accelerations, multipliers, pivots } = solution;
            accelerations.iter().chain(multipliers).chain(pivots.iter().flatten())
        });
        let quantities = self.quantities.iter().map(|quantity| &quantity.value);
        let points = self.points.iter().chain(&self.feet).chain(&self.energy).chain(quantities);
        let points = points.chain(self.slips.iter().flatten());
        kernel.iter().chain(phases).chain(held).chain(points).chain(&loops).copied().collect()
    }
}
