//! Conditions on a motion, as they are asked for.

mod watch;

pub(crate) use watch::Watch;

use crate::motion::Action;

/// A number that depends on a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A number.
    Number(f64),
    /// π.
    Pi,
    /// t.
    Time,
    /// A derivative of a coordinate of the public state.
    Coordinate {
        /// Its place.
        index: usize,
        /// Of the derivative.
        order: usize,
    },
    /// A derivative of the position of a point along an axis.
    Point {
        /// Its name.
        name: String,
        /// 0 for x, 1 for y.
        axis: usize,
        /// Of the derivative.
        order: usize,
    },
    /// The sum of the reactions of supports.
    Reaction(Vec<String>),
    /// The gap of a support.
    Gap(String),
    /// T.
    Kinetic,
    /// V.
    Potential,
    /// f(x).
    Apply(Function, Box<Expression>),
    /// a + b, …
    Join(Operator, Box<Expression>, Box<Expression>),
    /// xⁿ.
    Power(Box<Expression>, i32),
}

/// Functions of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// −x.
    Negate,
    /// √x.
    Sqrt,
    /// sin x.
    Sin,
    /// cos x.
    Cos,
    /// tan x.
    Tan,
}

/// Operations on two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// a + b.
    Add,
    /// a − b.
    Subtract,
    /// a · b.
    Multiply,
    /// a / b.
    Divide,
}

/// When a difference meets its condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// It changes its sign.
    Changes,
    /// It falls below zero.
    Falls,
    /// It rises above zero.
    Rises,
}

/// A condition, met where it becomes true; not where a motion begins with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// What is compared with zero.
    pub difference: Expression,
    /// How.
    pub relation: Relation,
    /// What is done once where it is met; the motion ends there if nothing is.
    pub action: Option<Action>,
}
