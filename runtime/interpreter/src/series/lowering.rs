//! Operations on Taylor coefficients: linear ones are plain arithmetic, the others take a column of
//! the tape. Sines and cosines are by their recurrence whatever the program makes them of, which is
//! where their values come from.

use std::collections::BTreeMap;

use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::functions::SeriesScope;
use liftoff_codegen::program::{self, Id, Part};

use super::code::{SeriesCode, SeriesInstruction, SeriesOperation};
use crate::code::{self, Lowering, Register, Source};

pub(super) struct SeriesWriter<'a> {
    scope: &'a SeriesScope<'a>,
    /// What is computed at order 0 alone, and all registers.
    values: Lowering<'a>,
    terms: BTreeMap<Id, Register>,
    /// How late in an order each coefficient is known.
    lateness: BTreeMap<Id, usize>,
    waves: BTreeMap<Vec<(Id, i16)>, [Register; 2]>,
    instructions: Vec<SeriesInstruction>,
    columns: usize,
}

/// Rates, reactions, gaps and feet.
type Outputs = (Vec<Register>, Vec<Register>, Vec<Option<Register>>, Vec<Register>);

impl<'a> SeriesWriter<'a> {
    /// Writes one order of `outputs`.
    pub fn new(
        scope: &'a SeriesScope<'a>,
        constants: &[Id],
        entries: usize,
        source: &'a dyn Fn(Symbol) -> Source,
        outputs: &[Id],
    ) -> Self {
        let mut writer = Self {
            scope,
            values: Lowering::new(scope.program, constants, entries, source),
            terms: BTreeMap::new(),
            lateness: BTreeMap::new(),
            waves: BTreeMap::new(),
            instructions: Vec::new(),
            columns: 0,
        };
        let (needed, _) = scope.needed(outputs);
        needed.into_iter().for_each(|id| writer.write(id));
        writer
    }

    /// The code; its state has so many entries, and whether the one after the rates is the time.
    pub fn finish(
        self,
        (rates, reactions, gaps, feet): Outputs,
        (entries, timed): (usize, bool),
    ) -> SeriesCode {
        let Lowering { instructions: values, ratios, registers, .. } = self.values;
        let (instructions, columns) = (self.instructions, self.columns);
        SeriesCode {
            instructions,
            values,
            ratios,
            rates,
            reactions,
            gaps,
            feet,
            entries,
            timed,
            registers,
            columns,
            #[cfg(feature = "jit")]
            native: Default::default(),
        }
    }

    fn varies(&self, id: Id) -> bool {
        !self.scope.program.is_constant(id)
    }

    fn push(&mut self, operation: SeriesOperation) -> Register {
        let to = self.values.fresh();
        self.instructions.push(SeriesInstruction { operation, to });
        to
    }

    fn column(&mut self) -> usize {
        self.columns += 1;
        self.columns - 1
    }

    /// The coefficient of a value: zero above order 0 where it does not vary.
    pub fn term(&mut self, id: Id) -> Register {
        if let Some(&known) = self.terms.get(&id) {
            return known;
        }
        let value = self.value(id);
        let term = self.push(SeriesOperation::Constant(value));
        self.terms.insert(id, term);
        term
    }

    /// What does not vary, or what does at order 0.
    fn value(&mut self, id: Id) -> Register {
        let before = self.values.instructions.len();
        let register = self.values.register(id);
        let count = self.values.instructions.len() - before;
        if count > 0 {
            self.instructions.push(SeriesInstruction { operation: SeriesOperation::Values(count), to: 0 });
        }
        register
    }

    fn know(&mut self, id: Id, term: Register) {
        self.terms.insert(id, term);
        // At order 0 it is the value.
        self.values.known.insert(id, term);
    }

    fn write(&mut self, id: Id) {
        let lateness = self.scope.lateness(id, &self.lateness);
        self.lateness.insert(id, lateness);
        if !self.varies(id) || self.terms.contains_key(&id) {
            return;
        }
        let program = self.scope.program;
        if let Some(wave) = program.wave(id) {
            return self.wave(id, wave);
        }
        if let Some(other) = self.scope.stands_for(id) {
            let term = self.term(other);
            return self.know(id, term);
        }
        let term = match program.operation(id) {
            program::Operation::Input(_) => self.values.register(id),
            program::Operation::Sin(angle) | program::Operation::Cos(angle) => return self.sin_cos(angle),
            operation => match (self.scope.magnitude(id), self.scope.quotient(id)) {
                (Some(a), _) => {
                    let (column, a) = (self.column(), self.term(a));
                    self.push(SeriesOperation::Magnitude(column, a))
                }
                (None, quotient) => {
                    self.operation(quotient.map_or(operation, |(a, b)| program::Operation::Div(a, b)))
                }
            },
        };
        self.know(id, term);
    }

    fn operation(&mut self, operation: program::Operation) -> Register {
        match operation {
            program::Operation::Mul(a, b) if self.varies(a) && self.varies(b) => self.product(a, b),
            program::Operation::MulAdd(a, b, c) if self.varies(a) && self.varies(b) => {
                let product = self.product(a, b);
                self.plus(product, c)
            }
            program::Operation::Div(a, b) if self.varies(b) => {
                let column = self.column();
                let under = self.term(b);
                let quotient = match self.varies(a) {
                    true => SeriesOperation::Quotient(column, self.term(a), under),
                    false => SeriesOperation::Inverse(column, self.value(a), under),
                };
                self.push(quotient)
            }
            program::Operation::Sqrt(a) => {
                let (column, a) = (self.column(), self.term(a));
                self.push(SeriesOperation::Sqrt(column, a))
            }
            program::Operation::Elementary(function, a) => {
                let (column, a) = (self.columns, self.term(a));
                self.columns += function.columns();
                self.push(SeriesOperation::Elementary(function, column, a))
            }
            linear => self.linear(linear),
        }
    }

    /// The operand that is known later stands first: it is the last to be multiplied.
    fn product(&mut self, a: Id, b: Id) -> Register {
        let column = self.column();
        let late = |id: Id| self.lateness.get(&id);
        let (later, earlier) = if late(a) > late(b) { (a, b) } else { (b, a) };
        let (later, earlier) = (self.term(later), self.term(earlier));
        self.push(if a == b {
            SeriesOperation::Square(column, later)
        } else {
            SeriesOperation::Product(column, later, earlier)
        })
    }

    /// A coefficient plus a value, which is felt at order 0 only where it does not vary.
    fn plus(&mut self, term: Register, id: Id) -> Register {
        let sum = match self.varies(id) {
            true => SeriesOperation::Add(term, self.term(id)),
            false => SeriesOperation::Offset(term, self.value(id)),
        };
        self.push(sum)
    }

    fn linear(&mut self, operation: program::Operation) -> Register {
        let linear = match operation {
            program::Operation::Add(a, b) if !self.varies(a) => {
                SeriesOperation::Offset(self.term(b), self.value(a))
            }
            program::Operation::Add(a, b) => {
                let term = self.term(a);
                return self.plus(term, b);
            }
            program::Operation::Sub(a, b) if !self.varies(a) => {
                let term = self.term(b);
                let minus = self.push(SeriesOperation::Neg(term));
                SeriesOperation::Offset(minus, self.value(a))
            }
            program::Operation::Sub(a, b) if !self.varies(b) => {
                SeriesOperation::OffsetBack(self.term(a), self.value(b))
            }
            program::Operation::Sub(a, b) => SeriesOperation::Sub(self.term(a), self.term(b)),
            program::Operation::Mul(a, b) => {
                let (factor, x) = if self.varies(a) { (b, a) } else { (a, b) };
                SeriesOperation::Scale(self.term(x), self.value(factor))
            }
            program::Operation::Div(a, b) => SeriesOperation::Divide(self.term(a), self.value(b)),
            program::Operation::MulAdd(a, b, c) => {
                let (factor, x) = if self.varies(a) { (b, a) } else { (a, b) };
                let (x, factor) = (self.term(x), self.value(factor));
                match self.varies(c) {
                    true => SeriesOperation::ScaleAdd(x, factor, self.term(c)),
                    false => {
                        let scaled = self.push(SeriesOperation::Scale(x, factor));
                        SeriesOperation::Offset(scaled, self.value(c))
                    }
                }
            }
            program::Operation::Neg(a) => SeriesOperation::Neg(self.term(a)),
            // Leaves and what has been dealt with.
            _ => SeriesOperation::Constant(self.values.fresh()),
        };
        self.push(linear)
    }

    /// The sine and the cosine of a value.
    fn sin_cos(&mut self, angle: Id) {
        let program = self.scope.program;
        let found =
            [program::Operation::Sin(angle), program::Operation::Cos(angle)].map(|of| program.find(of));
        let pair = match self.waves.get(&[(angle, 1)][..]) {
            Some(&known) => known,
            None => {
                let term = self.term(angle);
                let value = self.value(angle);
                let [sin, cos] = [self.values.fresh(), self.values.fresh()];
                let operation = code::Operation::SinCos;
                self.values.instructions.push(code::Instruction { operation, to: sin, of: [value, cos, 0] });
                self.instructions.push(SeriesInstruction { operation: SeriesOperation::Values(1), to: 0 });
                self.pair(&[(angle, 1)], term, [sin, cos])
            }
        };
        for (id, term) in found.into_iter().zip(pair) {
            id.into_iter().for_each(|id| self.know(id, term));
        }
    }

    /// What is made by addition theorems: its value is, its coefficients are those of a sine and
    /// cosine.
    fn wave(&mut self, id: Id, wave: &program::WaveStep) {
        let [sine, cosine] = match self.waves.get(&wave.angle) {
            Some(&known) => known,
            None => {
                let values = [self.value(wave.sin_cos.0), self.value(wave.sin_cos.1)];
                let term = self.combination(&wave.angle);
                self.pair(&wave.angle, term, values)
            }
        };
        let term = match wave.part {
            Part::Sine => sine,
            Part::Cosine => cosine,
            Part::Versed => {
                let value = self.value(id);
                self.push(SeriesOperation::Versed(value, cosine))
            }
        };
        self.know(id, term);
    }

    /// A sine and a cosine with these values.
    fn pair(&mut self, angle: &[(Id, i16)], term: Register, values: [Register; 2]) -> [Register; 2] {
        let column = self.columns;
        self.columns += 2;
        let pair = [self.values.fresh(), self.values.fresh()];
        let operation = SeriesOperation::SinCos { column, angle: term, cos: pair[1], values };
        self.instructions.push(SeriesInstruction { operation, to: pair[0] });
        self.waves.insert(angle.to_vec(), pair);
        pair
    }

    /// Σ k x.
    fn combination(&mut self, angle: &[(Id, i16)]) -> Register {
        let mut sum: Option<Register> = None;
        for &(id, k) in angle {
            let x = self.term(id);
            let size = k.checked_abs().unwrap_or(i16::MAX);
            let multiple = if size == 1 { x } else { self.push(SeriesOperation::Times(x, size)) };
            sum = Some(match (sum, k < 0) {
                (None, false) => multiple,
                (None, true) => self.push(SeriesOperation::Neg(multiple)),
                (Some(sum), false) => self.push(SeriesOperation::Add(sum, multiple)),
                (Some(sum), true) => self.push(SeriesOperation::Sub(sum, multiple)),
            });
        }
        sum.unwrap_or_else(|| self.values.fresh())
    }
}
