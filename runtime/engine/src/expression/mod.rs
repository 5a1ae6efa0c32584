//! Quantities of a motion as text: `y(D)`, `phi'`, `N(A, C, E) / (m * g)`, and conditions on them.

mod condition;
mod enclosure;
mod environment;
mod evaluate;
mod formula;
mod interval;
mod parse;
pub(crate) mod resolve;
mod rounding;
mod series;
pub mod si_unit;
mod significant;
#[cfg(test)]
mod tests;
mod token;
mod tree;

pub use condition::Condition;
pub(crate) use condition::Relation;
pub(crate) use enclosure::Enclosure;
pub use environment::{Environment, Variable};
pub use formula::Formula;
pub(crate) use interval::Interval;
pub use resolve::{contact_of, contact_set, unknown_support};
pub(crate) use series::{Known, Sides};
pub use significant::{significant, superscript, unrounded};
pub use tree::{Function, Operator};

use core::fmt;

use thiserror::Error;

use crate::error::NameError;
use crate::integration::phase_point::{PhasePoint, RunContext};
use crate::model::Layout;
use parse::Parser;
use resolve::Vocabulary;
use tree::Expression;

/// Characters of an expression.
const LONGEST: usize = 10_000;
/// Operators of an expression, which bound how deep its tree is.
const MOST_OPERATORS: usize = 1000;

/// A quantity of a motion.
///
/// Numbers, `+ - * / ^`, parentheses, `sqrt sin cos tan abs`, `pi`, parameters, `t`; coordinates `phi`, rates `phi'`,
/// accelerations `phi''`; position, velocity and acceleration of a point `x(P) y(P) vx(P) vy(P) ax(P) ay(P)`;
/// the reaction of a support or tension of a thread `N(A)`, of a whole contact `N(A, C, E)`; the friction force of a support
/// that has friction or is rough `R(A)`, and `ratio(A)` = R/N, of a guide R/|N|; of one with friction its slip velocity `v(A)` and the
/// coefficient `mu(A)` that bounds |R|/N, the static one while it sticks; `gap(A)`; energies `T`, `V`, `E`, and `D`, what friction,
/// dampers and impacts have taken since the start, of a motion that was recorded; any of the model's
/// [quantities](crate::model::Layout::quantities): joint forces `fx(D, AD)`, spring forces `force(AB)`, momenta `px`.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    text: String,
    expression: Expression,
}

impl Output {
    /// Reads an expression with the names of a model.
    pub fn parse(layout: &'static Layout, text: &str) -> Result<Self, OutputError> {
        let mut parser = Parser::new(text, Vocabulary::of(layout))?;
        let expression = parser.sum()?;
        parser.end()?;
        Ok(Self { text: text.trim().to_owned(), expression })
    }

    /// Whether it depends on what the motion was before: only a recorded motion has it.
    pub fn reads_history(&self) -> bool {
        self.expression.reads_history()
    }

    /// Its value over what gives its variables their values.
    ///
    /// # Errors
    /// One of its variables or functions has none there.
    pub fn value_in<E: Environment>(&self, environment: &E) -> Result<E::Value, E::Error> {
        environment::evaluate(&self.expression, environment)
    }

    pub(crate) fn evaluate(&self, context: &RunContext, point: &PhasePoint) -> f64 {
        evaluate::evaluate(&self.expression, context, point)
    }
}

impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Text that is no expression of the model.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum OutputError {
    /// A character or word in the wrong place.
    #[error("expected {expected}, found {found} at column {column}")]
    Unexpected {
        /// What could have stood there.
        expected: &'static str,
        /// What does.
        found: String,
        /// Where, counted from 1.
        column: usize,
    },
    /// An unknown name.
    #[error(transparent)]
    Name(#[from] NameError),
    /// What books call a centre of mass, which no point of the model is called.
    #[error(
        "no name `{name}`: write `x(A)` for the x of point A; a centre of mass is a point if the declaration says so, `#[point(G = AB, at = l / 2)]`"
    )]
    Centre {
        /// What was asked for.
        name: String,
    },
    /// The share of one support is not determined.
    #[error("only the total reaction of {contact} is determined: write N({contact})")]
    NotShared {
        /// The contact's label.
        contact: String,
    },
    /// Supports that do not make up one contact.
    #[error("{supports} are no single contact")]
    NoContact {
        /// The supports given.
        supports: String,
    },
    /// A friction force or a slip velocity is asked of a smooth contact.
    #[error(
        "{contact} is smooth, with neither a friction force nor a slip velocity: declare it with `friction = mu`, or `rough`"
    )]
    Smooth {
        /// The contact's label.
        contact: String,
    },
    /// A slip velocity is asked of a contact that does not slip.
    #[error("{contact} is rough and does not slip: declare it with `friction = mu` in place of `rough`")]
    Rough {
        /// The contact's label.
        contact: String,
    },
    /// A condition on nothing that moves: it holds always or never, and cannot become true.
    #[error("`{condition}` holds always or never: it cannot end a run")]
    Constant {
        /// The condition.
        condition: String,
    },
    /// A condition on what only a recorded motion has.
    #[error(
        "`{condition}` depends on the energy lost before, `D`, which only a finished motion has: it cannot end a run"
    )]
    History {
        /// The condition.
        condition: String,
    },
    /// More text than any expression has.
    #[error("an expression of {characters} characters: {LONGEST} are the most")]
    Length {
        /// Length of the text.
        characters: usize,
    },
    /// More operators than any expression has.
    #[error("more than {MOST_OPERATORS} operators, at column {column}")]
    Operators {
        /// Where the first of those is that are too many, counted from 1.
        column: usize,
    },
    /// Parentheses or signs nested too deeply.
    #[error("nested too deeply at column {column}")]
    Depth {
        /// Where, counted from 1.
        column: usize,
    },
}
