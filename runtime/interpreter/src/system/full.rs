//! Functions of the full state as code.

use core::ops::Range;

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::functions::{Functions, Mass};
use liftoff_codegen::program::Id;

use crate::code::{Code, Lowering, Source};
use crate::series::KernelCode;

/// The functions of the full state.
#[derive(Debug)]
pub(crate) struct FullCode {
    pub coordinates: usize,
    pub rows: usize,
    pub entries: usize,
    pub kernel: Code,
    pub mass: MassForm,
    pub energy: Code,
    pub points: Code,
    pub feet: Code,
    pub kinks: Code,
    /// v, μ and μₛ of each contact with friction.
    pub slips: Code,
    /// What computes each quantity, and which of its outputs it is.
    pub quantities: Vec<[usize; 2]>,
    pub quantity_codes: Vec<Code>,
    /// Where no contact is closed: rates and accelerations, then of each joint an entry with its pivot.
    pub joint_solution: Option<Code>,
    /// The series of the kernel, where phases need them.
    pub series: Option<KernelCode>,
}

/// What the mass matrix is made of.
#[derive(Debug)]
pub(crate) enum MassForm {
    /// Its entries.
    Entries,
    /// Vectors along the paths of a tree: the parents of its bodies.
    Paths(Vec<Option<usize>>),
}

impl FullCode {
    pub fn of(analysis: &Analysis, constants: &[Id]) -> Self {
        let (functions, motion) = (&analysis.functions, &analysis.motion);
        let (n, rows, entries) = (motion.n, motion.rows.len(), motion.entries());
        let source = |symbol: Symbol| match symbol {
            Symbol::Coordinate { index, order: 2 } => Source::Input(entries + usize::from(index)),
            Symbol::Coordinate { index, order } => Source::Input(usize::from(index) + n * usize::from(order)),
            Symbol::Reaction(row) => Source::Input(entries + n + usize::from(row)),
            carried => {
                let place = motion.carried().position(|symbol| symbol == carried);
                place.map_or(Source::Missing, |k| Source::Input(2 * n + k))
            }
        };
        let code = |inputs: usize, outputs: &[Id]| {
            Lowering::new(&functions.program, constants, inputs, &source).code(outputs)
        };
        let of_state = |outputs: &[Id]| code(entries, outputs);
        let kinks: Vec<Id> = functions.kinks.iter().map(|kink| kink.value()).collect();
        let slips: Vec<Id> = functions.slips.iter().flatten().copied().collect();
        let (quantities, groups) = quantities(functions);
        let joint_solution = functions.joint_solution.as_ref().map(|solution| {
            let derivative = solution.rates.iter().chain(&solution.accelerations);
            let outputs: Vec<Id> = derivative.chain(solution.pivots.iter().flatten()).copied().collect();
            of_state(&outputs)
        });
        let (mass, kernel) = kernel(functions, n);
        Self {
            coordinates: n,
            rows,
            entries,
            kernel: of_state(&kernel),
            mass,
            energy: of_state(&functions.energy),
            points: of_state(&functions.points),
            feet: of_state(&functions.feet),
            kinks: of_state(&kinks),
            slips: of_state(&slips),
            quantities,
            quantity_codes: groups.iter().map(|ids| code(entries + n + rows, ids)).collect(),
            joint_solution,
            series: KernelCode::of(analysis, constants, &kernel, &source),
        }
    }
}

/// The outputs of the kernel: f, g, b, ∂g/∂t, σμ, J, then what M is made of.
fn kernel(functions: &Functions, n: usize) -> (MassForm, Vec<Id>) {
    let kernel = &functions.kernel;
    let rows = kernel.gap.iter().chain(&kernel.bias).chain(&kernel.drift).chain(&kernel.friction);
    let outputs = kernel.force.iter().chain(rows).chain(kernel.jacobian.iter().flatten());
    let form = match &kernel.mass {
        Mass::Entries(_) => MassForm::Entries,
        Mass::Paths(paths) => MassForm::Paths(paths.parents.clone()),
    };
    (form, outputs.copied().chain(kernel.mass.written(n)).collect())
}

/// Of each quantity its group and its place there; the values of each group.
fn quantities(functions: &Functions) -> (Vec<[usize; 2]>, Vec<Vec<Id>>) {
    let ids: Vec<Id> = functions.quantities.iter().map(|quantity| quantity.value).collect();
    let Range { start, end } = functions.together;
    let (mut places, mut groups) = (Vec::new(), Vec::new());
    for (entry, &id) in ids.iter().enumerate() {
        if (start..end).contains(&entry) && entry > start {
            places.push([groups.len() - 1, entry - start]);
            continue;
        }
        places.push([groups.len(), 0]);
        groups.push(if entry == start && start < end { ids[start..end].to_vec() } else { vec![id] });
    }
    (places, groups)
}
