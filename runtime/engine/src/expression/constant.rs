//! Expressions of parameters alone, and what divides by them.

use super::environment::{Environment, Variable, evaluate};
use super::tree::{Expression, Function, Operator, is_count};

impl Expression {
    /// An expression with the same zeros that also changes its sign where this one may only touch
    /// zero: x for |x|, x² and −x.
    pub(super) fn vanishing(self) -> Self {
        match self {
            Self::Apply(Function::Negate | Function::Abs, x) => x.vanishing(),
            Self::Join(Operator::Power, x, n) if is_count(&n) => x.vanishing(),
            Self::Join(Operator::Multiply, x, y) if is_factor(&x) => y.vanishing(),
            Self::Join(Operator::Multiply | Operator::Divide, x, y) if is_factor(&y) => x.vanishing(),
            Self::Join(Operator::Multiply, x, y) => {
                Self::join(Operator::Multiply, x.vanishing(), y.vanishing())
            }
            Self::Join(Operator::Divide, x, y) => Self::join(Operator::Divide, x.vanishing(), *y),
            other => other,
        }
    }

    /// The value, if it depends on parameters only.
    pub(super) fn constant(&self, parameters: &[f64]) -> Option<f64> {
        evaluate(self, &Parameters(parameters)).ok()
    }
}

/// A number other than zero.
fn is_factor(x: &Expression) -> bool {
    x.constant(&[]).is_some_and(|x| x != 0.0 && x.is_finite())
}

/// Parameters, and nothing that moves.
struct Parameters<'a>(&'a [f64]);

/// Something moves, or there are too few parameters.
#[derive(Debug)]
struct NotConstant;

impl Environment for Parameters<'_> {
    type Value = f64;
    type Error = NotConstant;

    fn number(&self, x: f64) -> f64 {
        x
    }

    fn get_value(&self, variable: Variable) -> Result<f64, NotConstant> {
        match variable {
            Variable::Parameter(i) => self.0.get(i).copied().ok_or(NotConstant),
            _ => Err(NotConstant),
        }
    }

    fn apply(&self, function: Function, x: f64) -> Result<f64, NotConstant> {
        Ok(function.apply(x))
    }

    fn join(&self, operator: Operator, a: f64, b: f64) -> Result<f64, NotConstant> {
        Ok(operator.apply(a, b))
    }
}
