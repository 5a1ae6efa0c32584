//! The rounding of a condition: first-order bounds of what its operations lose (Higham, *Accuracy
//! and Stability of Numerical Algorithms*, 2nd ed., 3.3).

use core::convert::Infallible;

use super::condition::Condition;
use super::environment::{Environment, Variable};
use super::tree::{Function, Operator};
use crate::context::RunContext;
use crate::integration::phase_point::PhasePoint;
use crate::numerics::zero::roundoff;

/// Rounding of what is read of a motion: it comes from some operations.
const READ: f64 = roundoff(32.0);

/// A number and what it may be off by.
#[derive(Debug, Clone, Copy)]
struct Rounded {
    value: f64,
    error: f64,
}

impl Condition {
    /// What rounding may make of left side less right side where they are equal.
    pub(crate) fn rounding(&self, context: &RunContext, point: &PhasePoint) -> f64 {
        let Ok([a, b]) = self.values(&PointEnvironment { context, point });
        Rounded::new(a.value - b.value, a.error + b.error).error
    }
}

/// A model at one time of its motion.
struct PointEnvironment<'a> {
    context: &'a RunContext,
    point: &'a PhasePoint,
}

impl Rounded {
    fn new(value: f64, error: f64) -> Self {
        Self { value, error: error + f64::EPSILON * value.abs() }
    }
}

impl Environment for PointEnvironment<'_> {
    type Value = Rounded;
    type Error = Infallible;

    fn number(&self, value: f64) -> Rounded {
        Rounded { value, error: 0.0 }
    }

    fn get_value(&self, variable: Variable) -> Result<Rounded, Infallible> {
        let value = variable.value(self.context, self.point);
        let size = match variable {
            Variable::Parameter(_) | Variable::Time => 0.0,
            Variable::Kinetic | Variable::Potential => {
                let energy = self.point.energy();
                energy.kinetic.abs() + energy.potential.abs()
            }
            _ => value.abs(),
        };
        Ok(Rounded { value, error: READ * size })
    }

    fn apply(&self, function: Function, x: Rounded) -> Result<Rounded, Infallible> {
        let value = function.apply(x.value);
        let slope = match function {
            Function::Negate | Function::Abs | Function::Sin | Function::Cos => 1.0,
            Function::Sqrt if value > 0.0 => 0.5 / value,
            Function::Sqrt => 0.0,
            Function::Tan => 1.0 + value * value,
            Function::Exp => value,
            Function::Log => 1.0 / x.value,
            Function::Tanh => 1.0 - value * value,
            Function::Atan => 1.0 / (1.0 + x.value * x.value),
            Function::Sign => 0.0,
        };
        Ok(Rounded::new(value, slope * x.error))
    }

    fn join(&self, operator: Operator, a: Rounded, b: Rounded) -> Result<Rounded, Infallible> {
        let value = operator.apply(a.value, b.value);
        let error = match operator {
            Operator::Add | Operator::Subtract => a.error + b.error,
            Operator::Multiply => a.error * b.value.abs() + b.error * a.value.abs(),
            Operator::Divide => (a.error + value.abs() * b.error) / b.value.abs(),
            Operator::Power => (b.value * value / a.value).abs() * a.error,
            Operator::Atan2 => {
                let turned = a.error * b.value.abs() + b.error * a.value.abs();
                turned / (a.value * a.value + b.value * b.value)
            }
            Operator::Where | Operator::Unless => b.error,
        };
        Ok(Rounded::new(value, error))
    }
}
