//! Values of expressions: one evaluator, over whatever gives its variables their values.

use super::tree::{Expression, Function, Operator};
use smallvec::SmallVec;

/// What an expression may read of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variable {
    /// A parameter, by its place in the layout.
    Parameter(usize),
    /// t, s.
    Time,
    /// A coordinate's `order`-th derivative, 0 to 2.
    Coordinate {
        /// Its place in the layout.
        index: usize,
        /// Of the derivative.
        order: usize,
    },
    /// A point's position, velocity or acceleration along an axis.
    Point {
        /// Its place in the layout.
        index: usize,
        /// 0 for x, 1 for y.
        axis: usize,
        /// Of the derivative.
        order: usize,
    },
    /// The reaction of a whole contact.
    Reaction(usize),
    /// The friction force of a whole contact, along its tangent.
    Friction(usize),
    /// The slip velocity of a contact with friction, by its entry of the layout's frictions.
    Slip(usize),
    /// The coefficient of friction of such an entry: the static one while it sticks.
    Coefficient(usize),
    /// An entry of the layout's quantities.
    Quantity(usize),
    /// The gap of a contact.
    Gap(usize),
    /// Kinetic energy.
    Kinetic,
    /// Potential energy.
    Potential,
    /// The energy lost since the start.
    Dissipated,
}

/// Gives variables their values and calculates with them.
pub trait Environment {
    /// A number, or a series of them.
    type Value;
    /// Why there is none.
    type Error;
    /// The value of a number that the text names.
    fn number(&self, x: f64) -> Self::Value;
    /// The value of a variable.
    fn get_value(&self, variable: Variable) -> Result<Self::Value, Self::Error>;
    /// f(x).
    fn apply(&self, function: Function, x: Self::Value) -> Result<Self::Value, Self::Error>;
    /// a + b, …
    fn join(&self, operator: Operator, a: Self::Value, b: Self::Value) -> Result<Self::Value, Self::Error>;
}

/// Operands of a sum or product for which nothing is allocated.
const USUAL: usize = 16;

/// The value of an expression. Left operands lie in one another as deep as a sum is long: they are
/// taken in turn, and recursion is as deep as parentheses are.
pub(super) fn evaluate<E: Environment>(
    expression: &Expression,
    environment: &E,
) -> Result<E::Value, E::Error> {
    let mut operands: SmallVec<[(Operator, &Expression); USUAL]> = SmallVec::new();
    let mut innermost = expression;
    while let Expression::Join(operator, left, right) = innermost {
        operands.push((*operator, right));
        innermost = left;
    }
    let first = operand(innermost, environment)?;
    operands.into_iter().rev().try_fold(first, |value, (operator, right)| {
        environment.join(operator, value, evaluate(right, environment)?)
    })
}

fn operand<E: Environment>(expression: &Expression, environment: &E) -> Result<E::Value, E::Error> {
    let of = |x: &Expression| evaluate(x, environment);
    let shared = |all: Variable, share: f64| {
        environment.join(Operator::Divide, environment.get_value(all)?, environment.number(share))
    };
    match *expression {
        Expression::Number(x) => Ok(environment.number(x)),
        Expression::Parameter(i) => environment.get_value(Variable::Parameter(i)),
        Expression::Time => environment.get_value(Variable::Time),
        Expression::Coordinate { index, order } => {
            environment.get_value(Variable::Coordinate { index, order })
        }
        Expression::Point { index, axis, order } => {
            environment.get_value(Variable::Point { index, axis, order })
        }
        Expression::Reaction { contact, share } => shared(Variable::Reaction(contact), share),
        Expression::Friction { contact, share } => shared(Variable::Friction(contact), share),
        Expression::Slip(entry) => environment.get_value(Variable::Slip(entry)),
        Expression::Coefficient(entry) => environment.get_value(Variable::Coefficient(entry)),
        Expression::Quantity(entry) => environment.get_value(Variable::Quantity(entry)),
        Expression::Gap(contact) => environment.get_value(Variable::Gap(contact)),
        Expression::Kinetic => environment.get_value(Variable::Kinetic),
        Expression::Potential => environment.get_value(Variable::Potential),
        Expression::Dissipated => environment.get_value(Variable::Dissipated),
        Expression::Energy => {
            let [kinetic, potential] =
                [Variable::Kinetic, Variable::Potential].map(|part| environment.get_value(part));
            environment.join(Operator::Add, kinetic?, potential?)
        }
        Expression::Apply(function, ref x) => environment.apply(function, of(x)?),
        Expression::Join(..) => of(expression),
    }
}
