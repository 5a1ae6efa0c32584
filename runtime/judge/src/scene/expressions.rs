//! Expressions of time and motion.

use super::Builder;
use crate::tape::{Node, Tape};
use liftoff_codegen::system::{Elementary, Formula, Function, Operator};
use liftoff_core::scalar::Scalar;

impl<S: Scalar> Builder<'_, S> {
    pub(super) fn formula(&mut self, formula: &Formula) -> Node {
        match formula {
            Formula::Constant(series) => self.constant(series),
            // The slip velocity and a switch: both are refused before.
            Formula::Slip | Formula::Switch(_) => self.tape.number(S::ratio(0, 1)),
            Formula::Time => self.tape.time(),
            Formula::Motion { reading, rate } => {
                let read = self.reading(*reading);
                if *rate { self.tape.rate(read) } else { read }
            }
            Formula::Apply(function, argument) => {
                let argument = self.formula(argument);
                self.applied(*function, argument)
            }
            Formula::Join(operator, left, right) => {
                let (left, right) = (self.formula(left), self.formula(right));
                match operator {
                    Operator::Add => self.tape.add(left, right),
                    Operator::Subtract => self.tape.subtract(left, right),
                    Operator::Multiply => self.tape.multiply(left, right),
                    Operator::Divide => self.tape.divide(left, right),
                }
            }
        }
    }

    fn applied(&mut self, function: Function, argument: Node) -> Node {
        match function {
            Function::Negate => self.tape.negate(argument),
            Function::Sqrt => self.tape.root(argument),
            Function::Sin => self.tape.sin_cos(argument)[0],
            Function::Cos => self.tape.sin_cos(argument)[1],
            Function::Tan => {
                let [sin, cos] = self.tape.sin_cos(argument);
                self.tape.divide(sin, cos)
            }
            Function::Elementary(Elementary::Exp) => self.tape.exponential(argument),
            Function::Elementary(Elementary::Log) => self.tape.logarithm(argument),
            // Refused before.
            Function::Elementary(Elementary::Table(_)) => argument,
            Function::Elementary(Elementary::Atan) => self.tape.arctangent(argument),
            // 1 − 2/(e²ˣ + 1).
            Function::Elementary(Elementary::Tanh) => {
                let twice = self.tape.add(argument, argument);
                let power = self.tape.exponential(twice);
                let [one, two] = [Tape::<S>::ONE, self.tape.number(S::ratio(2, 1))];
                let below = self.tape.add(power, one);
                let rest = self.tape.divide(two, below);
                self.tape.subtract(one, rest)
            }
            Function::Power(k) => {
                let one = Tape::<S>::ONE;
                let product = (0..k.unsigned_abs()).fold(one, |p, _| self.tape.multiply(p, argument));
                if k < 0 { self.tape.divide(one, product) } else { product }
            }
        }
    }
}
