//! Code without branches.

use cranelift_codegen::ir::InstBuilder;
use liftoff_core::scalar::Real;

use super::writer::FunctionWriter;
use crate::code::{Code, Instruction, Operation};

/// Writes all instructions; the outputs go to memory.
pub(super) fn write(writer: &mut FunctionWriter<'_>, code: &Code) {
    for &Instruction { operation, to, of: [a, b, c] } in &code.instructions {
        let value = match operation {
            Operation::Ratio => {
                let [p, q] = code.ratios[a as usize];
                writer.number(Real::ratio(p, q))
            }
            Operation::Pi => writer.number(Real::pi()),
            Operation::Neg => {
                let a = writer.load_register(a);
                writer.builder.ins().fneg(a)
            }
            Operation::Sqrt => {
                let a = writer.load_register(a);
                writer.builder.ins().sqrt(a)
            }
            Operation::MulAdd => {
                let [a, b, c] = [a, b, c].map(|register| writer.load_register(register));
                writer.mul_add(a, b, c)
            }
            // A function of the library: code with one is not compiled.
            Operation::Elementary(_) => continue,
            Operation::SinCos => {
                let x = writer.load_register(a);
                writer.sin_cos(x, [to, b]);
                continue;
            }
            Operation::Add | Operation::Sub | Operation::Mul | Operation::Div => {
                let [a, b] = [a, b].map(|register| writer.load_register(register));
                let instruction = writer.builder.ins();
                match operation {
                    Operation::Add => instruction.fadd(a, b),
                    Operation::Sub => instruction.fsub(a, b),
                    Operation::Mul => instruction.fmul(a, b),
                    _ => instruction.fdiv(a, b),
                }
            }
        };
        writer.set(to, value);
    }
    writer.keep(code.outputs.iter().copied());
}
