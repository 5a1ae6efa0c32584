//! First integrals as numbers.

use liftoff_codegen::algebra::{Quotient, Symbol};
use liftoff_codegen::motion::{Expression, OpaqueTerm};
use liftoff_codegen::system::{Function, Operator, System};

use super::Integral;
use crate::numeric::values::with_derived;

impl Integral {
    /// Its value with these parameters, at a state: n coordinates, then their rates.
    pub fn evaluate(&self, system: &System, parameters: &[f64], n: usize, state: &[f64]) -> f64 {
        let parameters = with_derived(system, parameters);
        let at = |i: usize| state.get(i).copied().unwrap_or(f64::NAN);
        evaluate(
            &self.value,
            &|symbol| match symbol {
                Symbol::Parameter(i) => parameters.get(usize::from(i)).copied().unwrap_or(f64::NAN),
                Symbol::Coordinate { index, order: order @ (0 | 1) } => {
                    at(usize::from(index) + n * usize::from(order))
                }
                _ => f64::NAN,
            },
            &self.opaque_terms,
        )
    }
}

fn evaluate(quotient: &Quotient, known: &dyn Fn(Symbol) -> f64, opaque_terms: &[OpaqueTerm]) -> f64 {
    quotient.evaluate(&|symbol| match symbol {
        Symbol::Opaque { index, order } => {
            let term =
                opaque_terms.get(usize::from(index)).and_then(|term| term.orders.get(usize::from(order)));
            term.map_or(f64::NAN, |expression| of_expression(expression, known, opaque_terms))
        }
        other => known(other),
    })
}

fn of_expression(expression: &Expression, known: &dyn Fn(Symbol) -> f64, opaque_terms: &[OpaqueTerm]) -> f64 {
    let of = |expression: &Expression| of_expression(expression, known, opaque_terms);
    match expression {
        Expression::Value(quotient) => evaluate(quotient, known, opaque_terms),
        Expression::Angle(angle) => {
            let terms = angle.terms().iter().map(|(symbol, k)| known(*symbol) * f64::from(*k));
            terms.sum::<f64>() + f64::from(angle.quarter_turns()) * core::f64::consts::FRAC_PI_2
        }
        Expression::Time => f64::NAN,
        Expression::Apply(function, x) => match (function, of(x)) {
            (Function::Negate, x) => -x,
            (Function::Sqrt, x) => x.sqrt(),
            (Function::Sin, x) => x.sin(),
            (Function::Cos, x) => x.cos(),
            (Function::Tan, x) => x.tan(),
            (Function::Power(n), x) => x.powi(*n),
            (Function::Elementary(function), x) => function.apply(x),
        },
        Expression::Join(operator, a, b) => match (operator, of(a), of(b)) {
            (Operator::Add, a, b) => a + b,
            (Operator::Subtract, a, b) => a - b,
            (Operator::Multiply, a, b) => a * b,
            (Operator::Divide, a, b) => a / b,
        },
    }
}
