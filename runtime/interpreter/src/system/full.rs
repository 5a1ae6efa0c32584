//! Functions of the full state as code.

use core::ops::Range;

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::functions::{Functions, HeldMotion, HeldSolution, Mass};
use liftoff_codegen::motion::Motion;
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
    pub gaps: Code,
    pub energy: Code,
    pub points: Code,
    pub feet: Code,
    pub kinks: Code,
    /// v, μ and μₛ of each contact with friction.
    pub slips: Code,
    /// What computes each quantity, and which of its outputs it is.
    pub quantities: Vec<[usize; 2]>,
    pub quantity_codes: Vec<Code>,
    /// Contact sets without a closed form that have code of their own.
    pub held: Vec<HeldCode>,
    /// The series of the kernel, where phases need them.
    pub series: Option<KernelCode>,
}

/// The motion in a contact set without a closed form.
#[derive(Debug)]
pub(crate) struct HeldCode {
    pub set: (u64, u64),
    /// Rates and accelerations, then of each pivot what it is left of and itself, then the
    /// reactions of closed rows.
    pub code: Code,
    /// How many numbers tell of pivots.
    pub pivots: usize,
    /// The place of each reaction among those, if it is none of an open contact.
    pub reactions: Vec<Option<usize>>,
}

impl HeldCode {
    fn lower(motion: &Motion, held: &HeldMotion, code: impl Fn(&[Id]) -> Code) -> Self {
        let HeldSolution { accelerations, multipliers, pivots } = &held.solution;
        let derivative = held.rates.iter().chain(accelerations);
        let outputs: Vec<Id> = derivative.chain(pivots.as_flattened()).chain(multipliers).copied().collect();
        let place = |row: usize| held.rows.iter().position(|&closed| closed == row);
        Self {
            set: (held.set.closed, held.set.stick),
            code: code(&outputs),
            pivots: 2 * pivots.len(),
            reactions: motion.rows_of_reactions().map(place).collect(),
        }
    }
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
    pub fn lower(analysis: &Analysis, constants: &[Id]) -> Self {
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
        let held = functions.held.iter().map(|held| HeldCode::lower(motion, held, of_state)).collect();
        let (mass, kernel) = kernel(functions, n);
        Self {
            coordinates: n,
            rows,
            entries,
            kernel: of_state(&kernel),
            mass,
            gaps: of_state(&functions.kernel.gap),
            energy: of_state(&functions.energy),
            points: of_state(&functions.points),
            feet: of_state(&functions.feet),
            kinks: of_state(&kinks),
            slips: of_state(&slips),
            quantities,
            quantity_codes: groups.iter().map(|ids| code(entries + n + rows, ids)).collect(),
            held,
            series: KernelCode::lower(analysis, constants, &kernel, &source),
        }
    }
}

/// The outputs of the kernel: f, g, b, ∂g/∂t, σμ, J, then what M is made of.
fn kernel(functions: &Functions, n: usize) -> (MassForm, Vec<Id>) {
    let kernel = &functions.kernel;
    let rows =
        kernel.gap.iter().chain(&kernel.bias).chain(&kernel.prescribed_gap_rate).chain(&kernel.friction);
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
