//! Conditions of a run as they are told to the judge.

use liftoff::__private::expression::{self, Environment, Variable};
use liftoff::Trajectory;
use liftoff_core::model::Layout;
use liftoff_judge::{Condition, Expression, Function, Operator, Relation};

/// What is beyond the judge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Beyond(&'static str);

impl core::fmt::Display for Beyond {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.0)
    }
}

/// A condition that is waited for in a run; none where it is a given time.
pub(super) fn translated(
    condition: &expression::Condition,
    run: &Trajectory,
) -> Result<Option<Condition>, Beyond> {
    let [left, right] = condition.values(&Names { layout: run.layout(), parameters: run.parameters() })?;
    if let (Expression::Time, given) | (given, Expression::Time) = (&left, &right)
        && is_fixed(given)
    {
        return Ok(None);
    }
    let text = condition.to_string();
    let relation = match () {
        () if text.contains('<') => Relation::Falls,
        () if text.contains('>') => Relation::Rises,
        () => Relation::Changes,
    };
    let difference = Expression::Join(Operator::Subtract, Box::new(left), Box::new(right));
    Ok(Some(Condition { difference, relation, action: None }))
}

fn is_fixed(of: &Expression) -> bool {
    match of {
        Expression::Number(_) | Expression::Pi => true,
        Expression::Apply(_, x) | Expression::Power(x, _) => is_fixed(x),
        Expression::Join(_, a, b) => is_fixed(a) && is_fixed(b),
        _ => false,
    }
}

struct Names<'a> {
    layout: &'static Layout,
    parameters: &'a [f64],
}

impl Names<'_> {
    fn supports(&self, contact: usize) -> Vec<String> {
        self.layout.contacts[contact].supports.iter().map(|&name| name.to_owned()).collect()
    }
}

impl Environment for Names<'_> {
    type Value = Expression;
    type Error = Beyond;

    /// What is read as π is meant as π.
    fn number(&self, x: f64) -> Expression {
        if x == core::f64::consts::PI { Expression::Pi } else { Expression::Number(x) }
    }

    fn get_value(&self, variable: Variable) -> Result<Expression, Beyond> {
        Ok(match variable {
            Variable::Parameter(i) => Expression::Number(self.parameters[i]),
            Variable::Time => Expression::Time,
            Variable::Coordinate { index, order } => Expression::Coordinate { index, order },
            Variable::Point { index, axis, order } => {
                Expression::Point { name: self.layout.points[index].to_owned(), axis, order }
            }
            Variable::Reaction(contact) => Expression::Reaction(self.supports(contact)),
            Variable::Gap(contact) => {
                let supports = self.supports(contact);
                Expression::Gap(supports.into_iter().next().unwrap_or_default())
            }
            Variable::Kinetic => Expression::Kinetic,
            Variable::Potential => Expression::Potential,
            Variable::Friction(_) => return Err(Beyond("tangential reactions")),
            Variable::Slip(_) | Variable::Coefficient(_) => return Err(Beyond("slip velocities")),
            Variable::Dissipated => return Err(Beyond("the energy lost before")),
            Variable::Quantity(_) => return Err(Beyond("forces within the system")),
        })
    }

    fn apply(&self, function: expression::Function, x: Expression) -> Result<Expression, Beyond> {
        let function = match function {
            expression::Function::Negate => Function::Negate,
            expression::Function::Sqrt => Function::Sqrt,
            expression::Function::Sin => Function::Sin,
            expression::Function::Cos => Function::Cos,
            expression::Function::Tan => Function::Tan,
            expression::Function::Abs => return Err(Beyond("absolute values")),
            expression::Function::Exp | expression::Function::Log | expression::Function::Tanh => {
                return Err(Beyond("exponentials and logarithms"));
            }
            expression::Function::Atan => return Err(Beyond("directions")),
            expression::Function::Sign => return Err(Beyond("signs")),
        };
        Ok(Expression::Apply(function, Box::new(x)))
    }

    fn join(
        &self,
        operator: expression::Operator,
        a: Expression,
        b: Expression,
    ) -> Result<Expression, Beyond> {
        let operator = match operator {
            expression::Operator::Add => Operator::Add,
            expression::Operator::Subtract => Operator::Subtract,
            expression::Operator::Multiply => Operator::Multiply,
            expression::Operator::Divide => Operator::Divide,
            expression::Operator::Power => return power(a, &b),
            expression::Operator::Atan2 => return Err(Beyond("directions")),
            expression::Operator::Where | expression::Operator::Unless => return Err(Beyond("choices")),
        };
        Ok(Expression::Join(operator, Box::new(a), Box::new(b)))
    }
}

/// xⁿ for whole n up to 64.
fn power(x: Expression, n: &Expression) -> Result<Expression, Beyond> {
    let whole = |n: f64| n.fract() == 0.0 && n.abs() <= 64.0;
    match *n {
        Expression::Number(n) if whole(n) => Ok(Expression::Power(Box::new(x), n as i32)),
        Expression::Apply(Function::Negate, ref n) => match **n {
            Expression::Number(n) if whole(n) => Ok(Expression::Power(Box::new(x), -n as i32)),
            _ => Err(Beyond("powers that are not whole")),
        },
        _ => Err(Beyond("powers that are not whole")),
    }
}
