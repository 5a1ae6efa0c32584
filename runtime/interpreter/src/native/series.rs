//! One order n > 0 of a series: the recurrences of `liftoff_core::series`.

use cranelift_codegen::ir::{InstBuilder, Value};

use super::writer::FunctionWriter;
use crate::code::Register;
use crate::series::{SeriesCode, SeriesOperation};

/// The arguments: registers, aₙ and bₙ of the columns, what operations keep, sums, n, 1/n.
const LEFT: usize = 1;
const RIGHT: usize = 2;
const KEPT: usize = 3;
const SUMS: usize = 4;
const ORDER: usize = 5;
const PART: usize = 6;

/// Writes all instructions; what is read of an order goes to memory.
pub(super) fn write(writer: &mut FunctionWriter<'_>, code: &SeriesCode) {
    for (operation, to) in code.operations() {
        let value = match operation {
            SeriesOperation::Values(_) => continue,
            SeriesOperation::SinCos { column, angle, cos, .. } => {
                let values = writer.turned(column, angle);
                writer.set(cos, values[1]);
                values[0]
            }
            linear_or_column => writer.coefficient(linear_or_column),
        };
        writer.set(to, value);
    }
    writer.keep(code.read_registers());
}

impl FunctionWriter<'_> {
    fn coefficient(&mut self, operation: SeriesOperation) -> Value {
        match operation {
            SeriesOperation::Constant(_)
            | SeriesOperation::Values(_)
            | SeriesOperation::SinCos { .. }
            | SeriesOperation::Magnitude(..)
            | SeriesOperation::Elementary(..) => self.number(0.0),
            SeriesOperation::Offset(a, _) | SeriesOperation::OffsetBack(a, _) => self.load_register(a),
            SeriesOperation::Neg(a) | SeriesOperation::Versed(_, a) => {
                let a = self.load_register(a);
                self.builder.ins().fneg(a)
            }
            SeriesOperation::Add(a, b) => self.of_two(a, b, |writer, a, b| writer.builder.ins().fadd(a, b)),
            SeriesOperation::Sub(a, b) => self.of_two(a, b, |writer, a, b| writer.builder.ins().fsub(a, b)),
            SeriesOperation::Scale(a, b) => self.of_two(a, b, |writer, a, b| writer.builder.ins().fmul(a, b)),
            SeriesOperation::Divide(a, b) => {
                self.of_two(a, b, |writer, a, b| writer.builder.ins().fdiv(a, b))
            }
            SeriesOperation::ScaleAdd(a, factor, b) => {
                let [a, factor, b] = [a, factor, b].map(|register| self.load_register(register));
                self.mul_add(a, factor, b)
            }
            SeriesOperation::Times(a, k) => {
                let (a, k) = (self.load_register(a), self.number(f64::from(k)));
                self.builder.ins().fmul(a, k)
            }
            SeriesOperation::Product(column, a, b) => {
                let [a, b] = [a, b].map(|register| self.load_register(register));
                let ([a0, b0], sum) = (self.kept(column), self.load(SUMS, column));
                let inner = self.mul_add(b, a0, sum);
                let product = self.mul_add(a, b0, inner);
                self.write(column, a, b);
                product
            }
            SeriesOperation::Square(column, a) => {
                let a = self.load_register(a);
                let ([twice, _], sum) = (self.kept(column), self.load(SUMS, column));
                let square = self.mul_add(a, twice, sum);
                self.write(column, a, a);
                square
            }
            SeriesOperation::Quotient(column, a, b) => {
                let [a, b] = [a, b].map(|register| self.load_register(register));
                let known = self.without_numerator(column, b);
                let [inverse, _] = self.kept(column);
                let quotient = self.mul_add(a, inverse, known);
                self.write(column, b, quotient);
                quotient
            }
            SeriesOperation::Inverse(column, _, b) => {
                let b = self.load_register(b);
                let quotient = self.without_numerator(column, b);
                self.write(column, b, quotient);
                quotient
            }
            SeriesOperation::Sqrt(column, a) => {
                let a = self.load_register(a);
                let [half_inverse, _] = self.kept(column);
                let known = self.minus_sum(column, half_inverse);
                let root = self.mul_add(a, half_inverse, known);
                self.write(column, root, root);
                root
            }
        }
    }

    fn of_two(&mut self, a: Register, b: Register, make: impl Fn(&mut Self, Value, Value) -> Value) -> Value {
        let [a, b] = [a, b].map(|register| self.load_register(register));
        make(self, a, b)
    }

    /// bₙ times the slope, less m times the inverse.
    fn without_numerator(&mut self, column: usize, b: Value) -> Value {
        let [inverse, slope] = self.kept(column);
        let known = self.minus_sum(column, inverse);
        self.mul_add(b, slope, known)
    }

    fn minus_sum(&mut self, column: usize, factor: Value) -> Value {
        let sum = self.load(SUMS, column);
        let product = self.builder.ins().fmul(sum, factor);
        self.builder.ins().fneg(product)
    }

    /// The coefficients of a sine and a cosine.
    fn turned(&mut self, column: usize, angle: Register) -> [Value; 2] {
        let (angle, [sin0, cos0]) = (self.load_register(angle), self.kept(column));
        let (order, part) = (self.arguments[ORDER], self.arguments[PART]);
        let sums = [column, column + 1].map(|column| self.load(SUMS, column));
        let [of_sin, of_cos] = sums.map(|sum| self.builder.ins().fmul(sum, part));
        let sin = self.mul_add(angle, cos0, of_sin);
        let opposite = self.mul_add(angle, sin0, of_cos);
        let cos = self.builder.ins().fneg(opposite);
        let rate = self.builder.ins().fmul(angle, order);
        self.write(column, rate, cos);
        self.write(column + 1, rate, sin);
        [sin, cos]
    }

    /// What an operation keeps of the values.
    fn kept(&mut self, column: usize) -> [Value; 2] {
        [2 * column, 2 * column + 1].map(|place| self.load(KEPT, place))
    }

    fn write(&mut self, column: usize, a: Value, b: Value) {
        self.store(LEFT, column, a);
        self.store(RIGHT, column, b);
    }
}
