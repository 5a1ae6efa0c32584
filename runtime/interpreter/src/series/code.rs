//! One order of a phase's series as instructions.

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::elementary::Elementary;
use liftoff_codegen::functions::{PhaseFunctions, SeriesScope};
use liftoff_codegen::program::Id;
use liftoff_core::series::SeriesOps;

use super::lowering::SeriesWriter;
use crate::code::{self, Register, Source};

/// An operation on coefficients; a column is its place on the tape. Constants are registers too.
#[derive(Clone, Copy, Debug)]
pub(crate) enum SeriesOperation {
    /// What does not vary.
    Constant(Register),
    /// a + what does not vary.
    Offset(Register, Register),
    /// a − what does not vary.
    OffsetBack(Register, Register),
    Add(Register, Register),
    Sub(Register, Register),
    Neg(Register),
    /// a times what does not vary.
    Scale(Register, Register),
    /// a over what does not vary.
    Divide(Register, Register),
    /// a times what does not vary, + c.
    ScaleAdd(Register, Register, Register),
    /// a times a whole number.
    Times(Register, i16),
    Product(usize, Register, Register),
    Square(usize, Register),
    Quotient(usize, Register, Register),
    /// What does not vary over b.
    Inverse(usize, Register, Register),
    Sqrt(usize, Register),
    Elementary(Elementary, usize, Register),
    Magnitude(usize, Register),
    /// Of an angle, with these values at order 0.
    SinCos {
        column: usize,
        angle: Register,
        cos: Register,
        values: [Register; 2],
    },
    /// The value, and the cosine.
    Versed(Register, Register),
    /// At order 0 alone: so many of the plain instructions.
    Values(usize),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct SeriesInstruction {
    pub operation: SeriesOperation,
    pub to: Register,
}

/// What an order computes of the coefficients of the state.
#[derive(Debug)]
pub(crate) struct SeriesCode {
    pub(super) instructions: Vec<SeriesInstruction>,
    /// What order 0 computes by the program's own operations, in the order of `Values`.
    pub(super) values: Vec<code::Instruction>,
    pub(super) ratios: Vec<[i64; 2]>,
    pub(super) rates: Vec<Register>,
    pub(super) reactions: Vec<Register>,
    pub(super) gaps: Vec<Option<Register>>,
    pub(super) feet: Vec<Register>,
    pub(super) entries: usize,
    /// Whether the entry after the rates is the time.
    pub(super) timed: bool,
    pub(crate) registers: usize,
    pub(crate) columns: usize,
    #[cfg(feature = "jit")]
    pub(super) native: crate::native::Lazy<crate::native::Order>,
}

impl SeriesCode {
    pub fn lower(
        analysis: &Analysis,
        constants: &[Id],
        phase: &PhaseFunctions,
        entries: usize,
        source: &dyn Fn(Symbol) -> Source,
    ) -> Self {
        let along = analysis.functions.series(&analysis.motion, phase);
        let scope = SeriesScope { phase, program: &analysis.functions.program };
        let mut writer = SeriesWriter::new(&scope, constants, entries, source, &along.outputs());
        let mut all = |ids: &[Id]| ids.iter().map(|&id| writer.term(id)).collect::<Vec<Register>>();
        let (rates, reactions, feet) = (all(&along.rates), all(&along.reactions), all(&along.feet));
        let gaps = along.gaps.iter().map(|gap| gap.map(|id| writer.term(id))).collect();
        writer.finish((rates, reactions, gaps, feet), (entries, analysis.motion.is_timed()))
    }

    /// What an order does, and where it goes.
    #[cfg(feature = "jit")]
    pub(crate) fn operations(&self) -> impl Iterator<Item = (SeriesOperation, Register)> + '_ {
        self.instructions.iter().map(|instruction| (instruction.operation, instruction.to))
    }

    /// The registers that are read of an order.
    #[cfg(feature = "jit")]
    pub(crate) fn read_registers(&self) -> impl Iterator<Item = Register> + '_ {
        let gaps = self.gaps.iter().flatten();
        self.rates.iter().chain(&self.reactions).chain(gaps).chain(&self.feet).copied()
    }

    /// Whether each operation has instructions: a magnitude needs more of the tape than its row, an
    /// exponential is a function of the library.
    #[cfg(feature = "jit")]
    pub(crate) fn is_native(&self) -> bool {
        use SeriesOperation::{Elementary, Magnitude};
        !self.operations().any(|(operation, _)| matches!(operation, Magnitude(..) | Elementary(..)))
    }

    /// One order: coefficient n of everything from that of the state, which follows the constants
    /// in the registers.
    pub(super) fn order(&self, ops: &mut impl SeriesOps<f64>, registers: &mut [f64], is_first: bool) {
        let mut values = &self.values[..];
        for &SeriesInstruction { operation, to } in &self.instructions {
            let at = |register: Register| registers[register as usize];
            let value = match operation {
                SeriesOperation::Constant(a) => ops.constant(at(a)),
                SeriesOperation::Offset(a, c) => ops.offset(at(a), at(c)),
                SeriesOperation::OffsetBack(a, c) => ops.offset(at(a), -at(c)),
                SeriesOperation::Add(a, b) => at(a) + at(b),
                SeriesOperation::Sub(a, b) => at(a) - at(b),
                SeriesOperation::Neg(a) => -at(a),
                SeriesOperation::Scale(a, c) => at(a) * at(c),
                SeriesOperation::Divide(a, c) => at(a) / at(c),
                SeriesOperation::ScaleAdd(a, c, b) => {
                    liftoff_core::scalar::Real::mul_add(at(a), at(c), at(b))
                }
                SeriesOperation::Times(a, k) => at(a) * f64::from(k),
                SeriesOperation::Product(column, a, b) => ops.product(column, at(a), at(b)),
                SeriesOperation::Square(column, a) => ops.square(column, at(a)),
                SeriesOperation::Quotient(column, a, b) => ops.quotient(column, at(a), at(b)),
                SeriesOperation::Inverse(column, c, b) => ops.inverse(column, at(c), at(b)),
                SeriesOperation::Sqrt(column, a) => ops.sqrt(column, at(a)),
                SeriesOperation::Elementary(Elementary::Exp, column, a) => ops.exp(column, at(a)),
                SeriesOperation::Elementary(Elementary::Log, column, a) => ops.ln(column, at(a)),
                SeriesOperation::Elementary(Elementary::Tanh, column, a) => ops.tanh(column, at(a)),
                SeriesOperation::Elementary(Elementary::Atan, column, a) => ops.atan(column, at(a)),
                SeriesOperation::Elementary(Elementary::Table(table), column, a) => {
                    ops.spline(column, at(a), &table.knots, &table.pieces)
                }
                SeriesOperation::Magnitude(column, a) => ops.magnitude(column, at(a)),
                SeriesOperation::SinCos { column, angle, cos: to_cos, values: [s, c] } => {
                    let (sin, cos) = ops.sin_cos(column, at(angle), || (at(s), at(c)));
                    registers[to_cos as usize] = cos;
                    sin
                }
                SeriesOperation::Versed(value, cos) => ops.versed(|| at(value), at(cos)),
                SeriesOperation::Values(count) => {
                    let (these, rest) = values.split_at(count);
                    values = rest;
                    if is_first {
                        code::run(these, &self.ratios, registers);
                    }
                    continue;
                }
            };
            registers[to as usize] = value;
        }
    }
}
