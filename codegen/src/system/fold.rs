//! Operations on formulas; on what parameters determine, at once.

use super::scope::Scope;
use super::{Formula, Function, Operator};
use crate::algebra::Series;

const ZERO: &str = "division by zero";

impl Scope<'_> {
    /// A function of a formula.
    ///
    /// # Errors
    /// It has no value.
    pub fn applied(&mut self, function: Function, of: Formula) -> Result<Formula, &'static str> {
        let Formula::Constant(value) = of else {
            return Ok(Formula::Apply(function, Box::new(of)));
        };
        let constants = &mut self.constants;
        let result = match function {
            Function::Negate => Ok(-value),
            Function::Sqrt => constants.sqrt(&value).ok_or("the root of a negative number"),
            Function::Sin => Ok(Series::sin(&constants.angle(&value))),
            Function::Cos => Ok(Series::cos(&constants.angle(&value))),
            Function::Tan => {
                let angle = constants.angle(&value);
                constants.divide(&Series::sin(&angle), &Series::cos(&angle)).ok_or(ZERO)
            }
            // No number of the field of the parameters and their roots.
            Function::Elementary(_) => {
                return Ok(Formula::Apply(function, Box::new(Formula::Constant(value))));
            }
            Function::Power(n) => self.power(&value, n).ok_or(ZERO),
        };
        result.map(Formula::Constant)
    }

    /// Two formulas joined.
    ///
    /// # Errors
    /// A division by zero.
    pub fn joined_by(&mut self, operator: Operator, a: Formula, b: Formula) -> Result<Formula, &'static str> {
        let zero = matches!(&b, Formula::Constant(divisor) if divisor.is_zero());
        if operator == Operator::Divide && zero {
            return Err(ZERO);
        }
        let (Formula::Constant(x), Formula::Constant(y)) = (&a, &b) else {
            return Ok(Formula::Join(operator, Box::new(a), Box::new(b)));
        };
        let constants = &mut self.constants;
        let value = match operator {
            Operator::Add => x + y,
            Operator::Subtract => x - y,
            Operator::Multiply => constants.multiply(x, y),
            Operator::Divide => constants.divide(x, y).ok_or(ZERO)?,
        };
        Ok(Formula::Constant(value))
    }
}
