//! Quantities of a motion as text: `y(D)`, `phi'`, `N(A, C, E) / (m * g)`, and conditions on them.

mod clause;
mod condition;
mod constant;
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
mod switch;
#[cfg(test)]
mod tests;
mod token;
mod tree;

pub(crate) use clause::Relation;
pub use condition::{Condition, IntoConditions};
pub(crate) use enclosure::Enclosure;
pub use environment::{Environment, Variable};
pub use formula::Formula;
pub(crate) use interval::Interval;
pub use resolve::{contact_of, contact_set, normalize_rate, unknown_support};
pub(crate) use series::{SeriesQuantity, Sides};
pub use significant::{significant, superscript, unrounded};
pub(crate) use switch::{Switch, Switched, Switches};
pub use tree::{Function, Operator};

use core::fmt;

use crate::context::RunContext;
use crate::error::OutputError;
use crate::integration::phase_point::PhasePoint;
use crate::model::Layout;
use parse::Parser;
use resolve::Vocabulary;
use tree::Expression;

/// A quantity of a motion.
///
/// Numbers, `+ - * / ^`, parentheses,
/// `sqrt sin cos tan abs exp log tanh atan sign min max clamp atan2`, `if(a > b, x, y)`, `pi`,
/// parameters, `t`; coordinates `phi`, rates `phi'`, accelerations `phi''`, also `rate(phi)`;
/// angles may have a unit, `30 deg`; position, velocity and acceleration of a point `x(P) y(P)
/// vx(P) vy(P) ax(P) ay(P)`, its speed `speed(P)`; the reaction of a support or tension of a thread
/// `N(A)`, of a whole contact `N(A, C, E)`; the friction force of a support that has friction or is
/// rough `R(A)`, and `ratio(A)` = R/N, of a guide R/|N|; of one with friction its slip velocity
/// `v(A)` and the coefficient `mu(A)` that bounds |R|/N, the static one while it sticks; `gap(A)`;
/// energies `T`, `V`, `E`, and `D`, what friction, dampers and impacts have taken since the start,
/// of a motion that was recorded; any of the model's
/// [quantities](crate::model::Layout::quantities): joint forces `fx(D, AD)`, spring forces
/// `force(AB)`, momenta `px`.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    text: String,
    expression: Expression,
}

impl Output {
    /// Reads an expression with the names of a model.
    pub fn parse(layout: &'static Layout, text: &str) -> Result<Self, OutputError> {
        let mut parser = Parser::new(text, Vocabulary::new(layout))?;
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
