//! Expressions that are no series: `κ = (k Δ + c ḋ)/√(x² + y²)`.

use super::Notation;
use crate::motion::Expression;
use crate::system::{Function, Operator};

impl Notation<'_> {
    /// An expression; `inside` a product, quotient or power a sum is put in parentheses.
    pub(super) fn expression(&self, expression: &Expression, inside: bool) -> String {
        let text = match expression {
            Expression::Value(quotient) => self.quotient(quotient),
            Expression::Angle(angle) => self.angle(angle),
            Expression::Time => "t".to_owned(),
            Expression::Apply(function, x) => return self.applied(*function, x),
            Expression::Join(Operator::Add, a, b) => self.joined(a, " + ", b, false),
            Expression::Join(Operator::Subtract, a, b) => {
                format!("{} − {}", self.expression(a, false), self.expression(b, true))
            }
            Expression::Join(Operator::Multiply, a, b) => return self.joined(a, " ", b, true),
            Expression::Join(Operator::Divide, a, b) => {
                return format!("{}/{}", self.expression(a, true), self.factor(b));
            }
        };
        let sum = text.contains(" + ") || text.contains(" − ") || text.starts_with('−');
        if inside && sum && !is_enclosed(&text) { format!("({text})") } else { text }
    }

    fn joined(&self, a: &Expression, sign: &str, b: &Expression, inside: bool) -> String {
        format!("{}{sign}{}", self.expression(a, inside), self.expression(b, inside))
    }

    /// One factor: products are put in parentheses too.
    fn factor(&self, expression: &Expression) -> String {
        let text = self.expression(expression, true);
        if text.contains(' ') && !is_enclosed(&text) { format!("({text})") } else { text }
    }

    fn applied(&self, function: Function, x: &Expression) -> String {
        let argument = || match self.expression(x, false) {
            text if text.chars().count() == 1 => format!(" {text}"),
            text => format!("({text})"),
        };
        match function {
            Function::Negate => format!("−{}", self.expression(x, true)),
            Function::Sqrt => format!("√({})", self.expression(x, false)),
            Function::Sin => format!("sin{}", argument()),
            Function::Cos => format!("cos{}", argument()),
            Function::Tan => format!("tan{}", argument()),
            Function::Power(n) => format!("{}^{n}", self.factor(x)),
        }
    }
}

/// Whether one pair of parentheses, with or without a root before it, holds all of it.
fn is_enclosed(text: &str) -> bool {
    let Some(rest) = text.trim_start_matches('√').strip_prefix('(') else { return false };
    let mut depth = 1;
    let closes = rest.char_indices().find(|(_, c)| {
        depth += match c {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        depth == 0
    });
    closes.is_some_and(|(at, _)| at + 1 == rest.len())
}
