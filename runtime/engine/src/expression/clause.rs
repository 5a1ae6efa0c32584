//! Comparisons, and several of them as one.

use super::tree::{Expression, Operator};
use crate::error::OutputError;

/// Comparisons that `and` and `or` join; each doubles what is computed of the others.
const MOST_CLAUSES: usize = 8;

/// How the sides are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Relation {
    Equal,
    Less,
    Greater,
}

/// A comparison, or several as one.
pub(super) struct Clause {
    pub(super) relation: Relation,
    pub(super) sides: [Expression; 2],
    /// How many comparisons.
    pub(super) count: usize,
}

impl Clause {
    /// Where the least (`sign` −1) or the greatest (1) of both margins is above 0.
    pub(super) fn combine(self, other: Self, sign: f64, text: &str) -> Result<Self, OutputError> {
        let count = self.count + other.count;
        if count > MOST_CLAUSES {
            return Err(OutputError::Clauses { most: MOST_CLAUSES });
        }
        let equation = || OutputError::Combined { condition: text.trim().to_owned() };
        let [one, other] = [self, other].map(Self::into_margin);
        let margin = Expression::extreme(sign, one.ok_or_else(equation)?, other.ok_or_else(equation)?);
        Ok(Self { relation: Relation::Greater, sides: [margin, Expression::Number(0.0)], count })
    }

    /// What is above 0 where it holds; nothing of an equation.
    pub(super) fn into_margin(self) -> Option<Expression> {
        let [left, right] = self.sides;
        let (above, below) = match self.relation {
            Relation::Equal => return None,
            Relation::Greater => (left, right),
            Relation::Less => (right, left),
        };
        Some(match below {
            Expression::Number(0.0) => above,
            below => Expression::join(Operator::Subtract, above, below),
        })
    }
}
