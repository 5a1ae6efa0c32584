//! Straight-line arithmetic over registers: constants, then inputs, then what is computed.
//!
//! The operations are those of the emitted code in the same order of operands, so that their bits
//! are the same.

mod lowering;

use liftoff_codegen::elementary::Elementary;
use liftoff_core::scalar::Real;

use crate::pool::{Lent, Number};
pub(crate) use lowering::{Lowering, Source};

/// A place in the register file.
pub(crate) type Register = u32;

/// What an instruction does with its operands a, b, c.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Operation {
    /// The rational a over b, in [`Code::ratios`].
    Ratio,
    Pi,
    Add,
    Sub,
    Mul,
    Div,
    Neg,
    /// a · b + c.
    MulAdd,
    Sqrt,
    Elementary(Elementary),
    /// The sine of a; its cosine goes to register b.
    SinCos,
}

/// One instruction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instruction {
    pub operation: Operation,
    pub to: Register,
    pub of: [Register; 3],
}

/// A function of constants and inputs.
#[derive(Debug)]
pub(crate) struct Code {
    pub instructions: Vec<Instruction>,
    pub ratios: Vec<[i64; 2]>,
    pub outputs: Vec<Register>,
    pub registers: usize,
    #[cfg(feature = "jit")]
    pub native: crate::native::Lazy<crate::native::Straight>,
}

impl Code {
    /// Whether each operation has instructions: an exponential is a function of the library.
    #[cfg(feature = "jit")]
    pub fn is_native(&self) -> bool {
        !self.instructions.iter().any(|instruction| matches!(instruction.operation, Operation::Elementary(_)))
    }

    /// Writes the outputs for these constants and inputs, which follow each other in the registers.
    pub fn evaluate<S: Number>(&self, constants: &[S], inputs: &[&[S]], outputs: &mut [S]) {
        let mut registers = Lent::<S>::new(self.registers);
        let mut first = 0;
        for values in core::iter::once(&constants).chain(inputs) {
            registers[first..first + values.len()].copy_from_slice(values);
            first += values.len();
        }
        S::run(self, &mut registers);
        for (output, &register) in outputs.iter_mut().zip(&self.outputs) {
            *output = registers[register as usize];
        }
    }
}

/// Executes instructions on registers.
#[inline]
pub(crate) fn run<S: Real>(instructions: &[Instruction], ratios: &[[i64; 2]], registers: &mut [S]) {
    for &Instruction { operation, to, of: [a, b, c] } in instructions {
        let at = |register: Register| registers[register as usize];
        let value = match operation {
            Operation::Ratio => {
                let [p, q] = ratios[a as usize];
                S::ratio(p, q)
            }
            Operation::Pi => S::pi(),
            Operation::Add => at(a) + at(b),
            Operation::Sub => at(a) - at(b),
            Operation::Mul => at(a) * at(b),
            Operation::Div => at(a) / at(b),
            Operation::Neg => -at(a),
            Operation::MulAdd => at(a).mul_add(at(b), at(c)),
            Operation::Sqrt => at(a).sqrt(),
            Operation::Elementary(Elementary::Exp) => at(a).exp(),
            Operation::Elementary(Elementary::Log) => at(a).ln(),
            Operation::Elementary(Elementary::Tanh) => at(a).tanh(),
            Operation::Elementary(Elementary::Atan) => at(a).atan(),
            Operation::Elementary(Elementary::Table(table)) => at(a).spline(&table.knots, &table.pieces),
            Operation::SinCos => {
                let (sin, cos) = at(a).sin_cos();
                registers[b as usize] = cos;
                sin
            }
        };
        registers[to as usize] = value;
    }
}
