//! A program's operations as instructions.

use std::collections::BTreeMap;

use liftoff_codegen::algebra::{Rational, Symbol};
use liftoff_codegen::program::{self, Id, Program};

use super::{Code, Instruction, Operation, Register};

/// Where an input of the program comes from.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Source {
    /// An input of the code.
    Input(usize),
    /// Another value of the program.
    Value(Id),
    /// Nowhere: not a number.
    Missing,
}

/// Instructions while they are written.
pub(crate) struct Lowering<'a> {
    program: &'a Program,
    source: &'a dyn Fn(Symbol) -> Source,
    constants: usize,
    pub known: BTreeMap<Id, Register>,
    pub instructions: Vec<Instruction>,
    pub ratios: Vec<[i64; 2]>,
    pub registers: usize,
}

impl<'a> Lowering<'a> {
    /// Of a program whose constants have the first registers and whose inputs, so many, the
    /// following.
    pub fn new(
        program: &'a Program,
        constants: &[Id],
        inputs: usize,
        source: &'a dyn Fn(Symbol) -> Source,
    ) -> Self {
        let known = constants.iter().copied().zip(0..).collect();
        let registers = constants.len() + inputs;
        let (instructions, ratios) = (Vec::new(), Vec::new());
        Self { program, source, constants: constants.len(), known, instructions, ratios, registers }
    }

    /// The code that gives these values.
    pub fn code(mut self, outputs: &[Id]) -> Code {
        let outputs = outputs.iter().map(|&id| self.register(id)).collect();
        let Self { instructions, ratios, registers, .. } = self;
        Code {
            instructions,
            ratios,
            outputs,
            registers,
            #[cfg(feature = "jit")]
            native: Default::default(),
        }
    }

    /// The register of a value, which is computed once.
    pub fn register(&mut self, id: Id) -> Register {
        let mut stack = vec![id];
        while let Some(&top) = stack.last() {
            let waits: Vec<Id> = if self.known.contains_key(&top) { Vec::new() } else { self.waits(top) };
            if !waits.is_empty() {
                stack.extend(waits);
                continue;
            }
            stack.pop();
            if !self.known.contains_key(&top) {
                self.write(top);
            }
        }
        self.known[&id]
    }

    /// What a value needs that has no register.
    fn waits(&self, id: Id) -> Vec<Id> {
        let mut operands: Vec<Id> = match self.program.operation(id) {
            program::Operation::Input(symbol) => match (self.source)(symbol) {
                Source::Value(other) => vec![other],
                Source::Input(_) | Source::Missing => Vec::new(),
            },
            operation => operation.operands().collect(),
        };
        operands.retain(|operand| !self.known.contains_key(operand));
        operands
    }

    /// A register that nothing is in.
    pub fn fresh(&mut self) -> Register {
        self.registers += 1;
        (self.registers - 1) as Register
    }

    /// Writes an instruction; its register.
    pub fn push(&mut self, operation: Operation, operands: &[Register]) -> Register {
        let to = self.fresh();
        let of = core::array::from_fn(|i| operands.get(i).copied().unwrap_or(0));
        self.instructions.push(Instruction { operation, to, of });
        to
    }

    fn write(&mut self, id: Id) {
        let at = |id: &Id| self.known[id];
        let (operation, operands): (Operation, Vec<Register>) = match self.program.operation(id) {
            program::Operation::Input(symbol) => {
                let register = match (self.source)(symbol) {
                    Source::Input(place) => (self.constants + place) as Register,
                    Source::Value(other) => at(&other),
                    Source::Missing => self.missing(),
                };
                self.known.insert(id, register);
                return;
            }
            program::Operation::Ratio(value) => return self.ratio(id, value),
            program::Operation::Sin(angle) | program::Operation::Cos(angle) => {
                return self.sin_cos(angle);
            }
            program::Operation::Pi => (Operation::Pi, Vec::new()),
            program::Operation::Add(a, b) => (Operation::Add, vec![at(&a), at(&b)]),
            program::Operation::Sub(a, b) => (Operation::Sub, vec![at(&a), at(&b)]),
            program::Operation::Mul(a, b) => (Operation::Mul, vec![at(&a), at(&b)]),
            program::Operation::Div(a, b) => (Operation::Div, vec![at(&a), at(&b)]),
            program::Operation::Neg(a) => (Operation::Neg, vec![at(&a)]),
            program::Operation::MulAdd(a, b, c) => (Operation::MulAdd, vec![at(&a), at(&b), at(&c)]),
            program::Operation::Sqrt(a) => (Operation::Sqrt, vec![at(&a)]),
            program::Operation::Elementary(function, a) => (Operation::Elementary(function), vec![at(&a)]),
        };
        let register = self.push(operation, &operands);
        self.known.insert(id, register);
    }

    /// 0 / 0.
    fn missing(&mut self) -> Register {
        let zero = self.exact([0, 1]);
        self.push(Operation::Div, &[zero, zero])
    }

    fn ratio(&mut self, id: Id, value: Rational) {
        // Programs hold no longer numbers.
        let part = |part: i128| i64::try_from(part).unwrap_or(i64::MAX);
        let register = self.exact([part(value.numerator()), part(value.denominator())]);
        self.known.insert(id, register);
    }

    fn exact(&mut self, ratio: [i64; 2]) -> Register {
        self.ratios.push(ratio);
        self.push(Operation::Ratio, &[(self.ratios.len() - 1) as Register])
    }

    fn sin_cos(&mut self, angle: Id) {
        let cos = self.fresh();
        let sin = self.push(Operation::SinCos, &[self.known[&angle], cos]);
        let found = [program::Operation::Sin(angle), program::Operation::Cos(angle)];
        for (operation, register) in found.into_iter().zip([sin, cos]) {
            if let Some(id) = self.program.find(operation) {
                self.known.insert(id, register);
            }
        }
    }
}
