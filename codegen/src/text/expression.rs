//! Expressions that are no series: `κ = (k Δ + c ḋ)/√(x² + y²)`.

use super::TextWriter;
use crate::math::Math;
use crate::motion::Expression;
use crate::system::{Function, Operator};

impl TextWriter<'_> {
    /// An expression.
    pub(super) fn expression(&self, expression: &Expression) -> Math {
        match expression {
            Expression::Value(quotient) => self.quotient(quotient),
            Expression::Angle(angle) => angle.math(self),
            Expression::Time => Math::symbol("t"),
            Expression::Apply(function, x) => applied(*function, self.expression(x)),
            Expression::Join(operator, a, b) => joined(*operator, self.expression(a), self.expression(b)),
        }
    }
}

fn joined(operator: Operator, a: Math, b: Math) -> Math {
    match operator {
        Operator::Add => Math::sum([a, if matches!(b, Math::Sum(_)) { b.group() } else { b }]),
        Operator::Subtract => Math::sum([a, b.minus()]),
        Operator::Multiply => Math::product([closed(a), b]),
        Operator::Divide => closed(a).over(b),
    }
}

/// What another factor or a bar may follow: `(sin t) m`, since `sin t m` could be the sine of
/// `t m`.
fn closed(math: Math) -> Math {
    if is_open(&math) { math.group() } else { math }
}

/// Whether it ends with the bare argument of a function.
fn is_open(math: &Math) -> bool {
    match math {
        Math::Apply { argument, .. } => !matches!(**argument, Math::Group(_)),
        Math::Product(factors) => factors.last().is_some_and(is_open),
        _ => false,
    }
}

fn applied(function: Function, x: Math) -> Math {
    let of = |function, x: Math| {
        let single = matches!(&x, Math::Symbol(name, 0) if name.is_letter());
        let argument = Box::new(if single { x } else { x.group() });
        Math::Apply { function, power: 1, argument }
    };
    match function {
        Function::Negate => x.minus(),
        Function::Sqrt => Math::Root(Box::new(x)),
        Function::Sin => of("sin", x),
        Function::Cos => of("cos", x),
        Function::Tan => of("tan", x),
        Function::Elementary(function) => of(function.name(), x),
        Function::Power(n) => x.power(n),
    }
}
