//! Conditions that end a run: `a = b`, `a < b`, `a > b`, comparisons joined by `and` and `or`, or
//! an expression that becomes zero.

use core::fmt;
use std::sync::Arc;

use super::clause::{Clause, Relation};
use super::environment::{self, Environment};
use super::evaluate;
use super::parse::Parser;
use super::resolve::Vocabulary;
use super::tree::Expression;
use crate::context::RunContext;
use crate::error::OutputError;
use crate::integration::phase_point::PhasePoint;
use crate::model::Layout;
use crate::numerics::zero::roundoff;

/// Of the size of two sides, what they may differ by where they are equal.
const ROUNDED: f64 = roundoff(64.0);

/// A condition on a motion; it is met when it becomes true, not where a run starts with it.
///
/// Shared, as runs and events keep it.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    text: Arc<str>,
    relation: Relation,
    sides: Arc<[Expression; 2]>,
    /// The right side, where it is a number.
    constant: Option<f64>,
}

/// What can be taken for conditions on a model, one of which is to be met: text or a [`Condition`].
pub trait IntoConditions {
    /// The conditions with the names of a model.
    ///
    /// # Errors
    /// The text is no condition, or names something that the model does not have.
    fn into_conditions(self, layout: &'static Layout) -> Result<Vec<Condition>, OutputError>;
}

impl IntoConditions for Condition {
    fn into_conditions(self, _: &'static Layout) -> Result<Vec<Condition>, OutputError> {
        Ok(vec![self])
    }
}

impl<T: AsRef<str>> IntoConditions for T {
    fn into_conditions(self, layout: &'static Layout) -> Result<Vec<Condition>, OutputError> {
        Condition::parse_each(layout, self.as_ref())
    }
}

impl Condition {
    /// Reads a condition with the names of a model.
    pub fn parse(layout: &'static Layout, text: &str) -> Result<Self, OutputError> {
        let mut parser = Parser::new(text, Vocabulary::new(layout))?;
        let Clause { relation, sides, .. } = parser.parse_any(text)?;
        parser.end()?;
        Self::refined(text.trim(), relation, sides)
    }

    /// Reads the conditions that `or` joins, each as one of its own; equations may be among them.
    pub fn parse_each(layout: &'static Layout, text: &str) -> Result<Vec<Self>, OutputError> {
        let mut parser = Parser::new(text, Vocabulary::new(layout))?;
        let mut all = Vec::new();
        loop {
            let start = parser.column();
            let Clause { relation, sides, .. } = parser.parse_all(text)?;
            let own: String = text.chars().take(parser.column() - 1).skip(start - 1).collect();
            all.push(Self::refined(own.trim(), relation, sides)?);
            if !parser.take_word("or") {
                parser.end()?;
                return Ok(all);
            }
        }
    }

    /// Refuses what cannot become true; a side that is to become zero is taken in the form that
    /// changes its sign there.
    fn refined(text: &str, relation: Relation, sides: [Expression; 2]) -> Result<Self, OutputError> {
        let [left, right] = &sides;
        if left.reads_history() || right.reads_history() {
            return Err(OutputError::History { condition: text.to_owned() });
        }
        // Where a direction jumps, it is not equal to what it is compared with.
        let jump = left.jump().or_else(|| right.jump());
        let jump = jump.filter(|function| relation != Relation::Equal || *function != "atan2");
        if let Some(function) = jump {
            return Err(OutputError::Jump { condition: text.to_owned(), function });
        }
        let fixed = left.is_fixed() && right.is_fixed() || left == right;
        let at = Self::named_time(relation, &sides, &[]);
        if fixed || at.is_some_and(|at| !(at >= 0.0 && at.is_finite())) {
            return Err(OutputError::Constant { condition: text.to_owned() });
        }
        let sides = match (relation, sides) {
            (Relation::Equal, [left, Expression::Number(0.0)]) => [left.vanishing(), Expression::Number(0.0)],
            (Relation::Equal, [Expression::Number(0.0), right]) => {
                [Expression::Number(0.0), right.vanishing()]
            }
            (_, sides) => sides,
        };
        let constant = sides[1].constant(&[]).filter(|value| value.is_finite());
        Ok(Self { text: text.into(), relation, sides: sides.into(), constant })
    }

    /// The condition that it does not hold, but for where its sides are equal.
    pub(crate) fn negated(&self) -> Self {
        let (relation, sign) = match self.relation {
            Relation::Equal => return self.clone(),
            Relation::Less => (Relation::Greater, ['<', '>']),
            Relation::Greater => (Relation::Less, ['>', '<']),
        };
        let text = match self.text.matches(['<', '>']).count() {
            1 => self.text.replace(sign[0], &sign[1].to_string()),
            _ => format!("not ({})", self.text),
        };
        let text = text.into();
        Self { text, relation, ..self.clone() }
    }

    pub(crate) fn relation(&self) -> Relation {
        self.relation
    }

    /// Left side less right side, and the larger of their sizes.
    pub(crate) fn difference(&self, context: &RunContext, point: &PhasePoint) -> (f64, f64) {
        let [left, right] = &*self.sides;
        let a = evaluate::evaluate(left, context, point);
        let b = self.constant.unwrap_or_else(|| evaluate::evaluate(right, context, point));
        (a - b, a.abs().max(b.abs()))
    }

    /// How far it holds: above 0 where it does; nothing of an equation.
    pub(crate) fn margin(&self, context: &RunContext, point: &PhasePoint) -> Option<f64> {
        let (difference, _) = self.difference(context, point);
        match self.relation {
            Relation::Greater => Some(difference),
            Relation::Less => Some(-difference),
            Relation::Equal => None,
        }
    }

    /// Whether it holds at a point, to within the rounding of its sides.
    pub(crate) fn holds(&self, context: &RunContext, point: &PhasePoint) -> bool {
        let (difference, size) = self.difference(context, point);
        match self.relation {
            Relation::Equal => difference.abs() <= ROUNDED * size,
            Relation::Less => difference < 0.0,
            Relation::Greater => difference > 0.0,
        }
    }

    /// The left side, and the right one where nothing moves it.
    pub(super) fn against_constant(&self, parameters: &[f64]) -> Option<(&Expression, f64)> {
        let [left, right] = &*self.sides;
        Some((left, self.constant.or_else(|| right.constant(parameters))?))
    }

    /// The left side and the right one.
    pub fn values<E: Environment>(&self, environment: &E) -> Result<[E::Value; 2], E::Error> {
        let [left, right] = &*self.sides;
        let left = environment::evaluate(left, environment)?;
        Ok([left, environment::evaluate(right, environment)?])
    }

    /// Whether series of its sides show by their size how well they converge: nothing in them has
    /// poles or kinks, which may lie within a step although the first terms are small.
    pub(crate) fn is_entire(&self) -> bool {
        self.sides.iter().all(Expression::is_entire)
    }

    /// The time that it names with these parameters, s, if it is an equation for nothing else.
    pub fn time(&self, parameters: &[f64]) -> Option<f64> {
        Self::named_time(self.relation, &self.sides, parameters)
    }

    fn named_time(relation: Relation, sides: &[Expression; 2], parameters: &[f64]) -> Option<f64> {
        match (relation, sides) {
            (Relation::Equal, [Expression::Time, value] | [value, Expression::Time]) => {
                value.constant(parameters)
            }
            _ => None,
        }
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
