//! Values of expressions in double-double, for references.

use super::condition::Condition;
use super::expression::{Expression, Function, Operator};
use crate::model::BarSystem;
use crate::reference::Instant;
use crate::scalar::{DoubleDouble, Real, Scalar};

/// What cannot be evaluated in double-double.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Unsupported(pub(crate) &'static str);

impl Condition {
    /// Left side less right side.
    pub(crate) fn precise_difference<M: BarSystem>(
        &self,
        at: &Instant<'_, M>,
    ) -> Result<DoubleDouble, Unsupported> {
        Ok(value(&self.left, at)? - value(&self.right, at)?)
    }
}

fn value<M: BarSystem>(expression: &Expression, at: &Instant<'_, M>) -> Result<DoubleDouble, Unsupported> {
    Ok(match expression {
        // What is read as π is meant as π.
        Expression::Number(x) if *x == core::f64::consts::PI => DoubleDouble::pi(),
        Expression::Number(x) => DoubleDouble::from_f64(*x),
        Expression::Parameter(i) => DoubleDouble::from_f64(at.parameter(*i)),
        Expression::Time => at.t,
        Expression::Coordinate { index, order: 2 } => at.accelerations().as_ref()[*index],
        Expression::Coordinate { index, order } => {
            at.state.as_ref()[index + order * M::LAYOUT.coordinates.len()]
        }
        Expression::Point { index, axis, order: 0 } => at.points().as_ref()[2 * index + axis],
        Expression::Point { .. } => return Err(Unsupported("velocities of points")),
        Expression::Reaction { contact, share } => {
            at.reactions().as_ref()[*contact] / DoubleDouble::from_f64(*share)
        }
        Expression::Friction { .. } => return Err(Unsupported("tangential reactions")),
        Expression::Quantity { entry, .. } => at.quantity(*entry),
        Expression::Gap(contact) => at.gap(*contact),
        Expression::Kinetic => at.energy().kinetic,
        Expression::Potential => at.energy().potential,
        Expression::Energy => at.energy().kinetic + at.energy().potential,
        Expression::Apply(function, x) => applied(*function, value(x, at)?),
        Expression::Join(operator, a, b) => return joined(*operator, value(a, at)?, value(b, at)?),
    })
}

fn applied(function: Function, x: DoubleDouble) -> DoubleDouble {
    match function {
        Function::Negate => -x,
        Function::Sqrt => x.sqrt(),
        Function::Sin => x.sin_cos().0,
        Function::Cos => x.sin_cos().1,
        Function::Tan => x.sin_cos().0 / x.sin_cos().1,
        Function::Abs => x.abs(),
    }
}

fn joined(operator: Operator, a: DoubleDouble, b: DoubleDouble) -> Result<DoubleDouble, Unsupported> {
    Ok(match operator {
        Operator::Add => a + b,
        Operator::Subtract => a - b,
        Operator::Multiply => a * b,
        Operator::Divide => a / b,
        Operator::Power => return power(a, b),
    })
}

/// xⁿ for whole n up to 64.
fn power(x: DoubleDouble, n: DoubleDouble) -> Result<DoubleDouble, Unsupported> {
    let exponent = n.to_f64();
    if n.lo() != 0.0 || exponent.fract() != 0.0 || exponent.abs() > 64.0 {
        return Err(Unsupported("powers that are not whole"));
    }
    let one = DoubleDouble::ratio(1, 1);
    let power = (0..exponent.abs() as u32).fold(one, |product, _| product * x);
    Ok(if exponent < 0.0 { one / power } else { power })
}
