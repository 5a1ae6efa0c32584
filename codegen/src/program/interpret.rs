//! The program evaluated in `f64`, operation by operation.

use super::{Id, Operation, Program};
use crate::algebra::Symbol;

impl Program {
    /// Values of `outputs` for these inputs.
    pub fn evaluate(&self, outputs: &[Id], input: &dyn Fn(Symbol) -> f64) -> Vec<f64> {
        let mut values: Vec<f64> = vec![f64::NAN; self.operations().len()];
        for id in self.reachable(outputs) {
            let at = |a: Id| values[a.index()];
            values[id.index()] = match self.operation(id) {
                Operation::Ratio(value) => value.to_f64(),
                Operation::Pi => core::f64::consts::PI,
                Operation::Input(symbol) => input(symbol),
                Operation::Add(a, b) => at(a) + at(b),
                Operation::Sub(a, b) => at(a) - at(b),
                Operation::Mul(a, b) => at(a) * at(b),
                Operation::Div(a, b) => at(a) / at(b),
                Operation::Neg(a) => -at(a),
                Operation::MulAdd(a, b, c) => at(a) * at(b) + at(c),
                Operation::Sqrt(a) => at(a).sqrt(),
                Operation::Sin(a) => at(a).sin(),
                Operation::Cos(a) => at(a).cos(),
                Operation::Elementary(function, a) => function.apply(at(a)),
            };
        }
        outputs.iter().map(|id| values[id.index()]).collect()
    }
}
