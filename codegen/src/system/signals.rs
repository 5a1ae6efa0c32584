//! Signals: expressions of time and motion that loads and drives follow, as the runtime reads them.
//! A step of an integration is accepted only over a signal that it has seen.

use syn::{BinOp, Expr, Ident, Lit, UnOp};

use super::{Elementary, Formula, Function, Operator};
use crate::syntax::plain;

/// A polynomial of up to this degree in time and motion is seen by every method.
const DEGREE: i32 = 8;

/// An expression that a load or a drive follows.
#[derive(Clone, Debug, PartialEq)]
pub struct Signal {
    /// As conditions are written: `sin(t)^2 * x(P)`.
    pub expression: String,
    /// Whether it prescribes a motion, so that a jump or a kink of it is none of a force.
    pub drives: bool,
}

impl Signal {
    /// The signal of an expression, with the constants that it may name; none of a polynomial.
    pub(super) fn new(
        constants: &[(Ident, Expr)],
        expr: &Expr,
        formula: &Formula,
        drives: bool,
    ) -> Option<Self> {
        // Kinks and jumps of loads are cut out of steps.
        if !drives && has_kink(formula) {
            return None;
        }
        let expression = degree(formula).is_none().then(|| text(constants, expr)).flatten()?;
        Some(Self { expression, drives })
    }
}

/// The degree of a polynomial; none of what is no polynomial, or one of a high degree.
fn degree(formula: &Formula) -> Option<i32> {
    let degree = match formula {
        Formula::Constant(_) | Formula::Switch(_) => 0,
        Formula::Time | Formula::Slip | Formula::Motion { .. } => 1,
        Formula::Apply(Function::Negate, argument) => degree(argument)?,
        Formula::Apply(Function::Power(n @ 0..), argument) => degree(argument)?.checked_mul(*n)?,
        Formula::Apply(..) => return None,
        Formula::Join(Operator::Add | Operator::Subtract, a, b) => degree(a)?.max(degree(b)?),
        Formula::Join(Operator::Multiply, a, b) => degree(a)? + degree(b)?,
        Formula::Join(Operator::Divide, a, b) => degree(a).filter(|_| b.as_series().is_some())?,
    };
    (degree <= DEGREE).then_some(degree)
}

/// Whether there is a root of what may vanish, a switch or a table.
fn has_kink(formula: &Formula) -> bool {
    match formula {
        Formula::Switch(_) | Formula::Apply(Function::Elementary(Elementary::Table(_)), _) => true,
        Formula::Apply(Function::Sqrt, radicand) if !is_positive(radicand) => true,
        Formula::Apply(_, argument) => has_kink(argument),
        Formula::Join(_, left, right) => has_kink(left) || has_kink(right),
        Formula::Constant(_) | Formula::Time | Formula::Slip | Formula::Motion { .. } => false,
    }
}

/// Whether it is above zero with all constants that are not subtracted, as 1 + x².
fn is_positive(formula: &Formula) -> bool {
    match formula {
        Formula::Constant(_) => true,
        Formula::Apply(Function::Sqrt | Function::Power(_), argument) => is_positive(argument),
        Formula::Join(Operator::Add, a, b) => {
            is_positive(a) && is_square(b) || is_square(a) && is_positive(b)
        }
        Formula::Join(Operator::Multiply | Operator::Divide, a, b) => is_positive(a) && is_positive(b),
        _ => false,
    }
}

/// Whether it is not below zero with such constants.
fn is_square(formula: &Formula) -> bool {
    match formula {
        Formula::Apply(Function::Sqrt, _) => true,
        Formula::Apply(Function::Power(n), _) if n % 2 == 0 => true,
        Formula::Join(Operator::Multiply, a, b) if a == b => true,
        Formula::Join(Operator::Add | Operator::Multiply | Operator::Divide, a, b) => {
            is_square(a) && is_square(b)
        }
        _ => is_positive(formula),
    }
}

/// An expression as conditions have it.
pub(super) fn text(constants: &[(Ident, Expr)], expr: &Expr) -> Option<String> {
    let inner = |expr: &Expr| text(constants, expr);
    match expr {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => Some(number.base10_digits().to_owned()),
            Lit::Float(number) => Some(number.base10_digits().to_owned()),
            _ => None,
        },
        Expr::Paren(paren) => inner(&paren.expr),
        Expr::Group(group) => inner(&group.expr),
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => Some(format!("(-{})", inner(&unary.expr)?)),
        Expr::Binary(binary) => {
            let operator = match binary.op {
                BinOp::Add(_) => '+',
                BinOp::Sub(_) => '-',
                BinOp::Mul(_) => '*',
                BinOp::Div(_) => '/',
                _ => return None,
            };
            let (left, right) = (inner(&binary.left)?, inner(&binary.right)?);
            // Bounds of a square are not below zero, those of a product are.
            let is_square = operator == '*' && left == right;
            Some(if is_square { format!("({left}^2)") } else { format!("({left} {operator} {right})") })
        }
        Expr::Path(path) => {
            let name = path.path.get_ident()?;
            let constant = constants.iter().find(|(constant, _)| constant == name);
            constant.map_or_else(|| Some(plain(name)), |(_, value)| inner(value))
        }
        Expr::Call(call) => {
            let Expr::Path(function) = &*call.func else { return None };
            let arguments: Option<Vec<String>> = call.args.iter().map(inner).collect();
            let (function, arguments) = (function.path.get_ident()?, arguments?.join(", "));
            Some(if function == "rate" {
                format!("{arguments}'")
            } else {
                format!("{function}({arguments})")
            })
        }
        Expr::MethodCall(call) if call.method == "powi" => {
            Some(format!("({}^{})", inner(&call.receiver)?, inner(call.args.first()?)?))
        }
        Expr::MethodCall(call) => Some(format!("{}({})", call.method, inner(&call.receiver)?)),
        _ => None,
    }
}
