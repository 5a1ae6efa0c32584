//! The conditions of a contact set, from its energy level to their zeros.

mod begin;
mod functions;
#[cfg(test)]
mod tests;

use liftoff_codegen::Analysis;
use liftoff_codegen::math::{Equation, Math};
use liftoff_codegen::phases::Phase;

use crate::error::ConditionError;
use crate::level::Level;
use crate::numeric::zeros::Numbers;
use crate::phase::Named;
use begin::Begin;
use functions::Functions;

/// Where a motion begins, and with which parameters.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Request {
    /// Coordinates (`phi`) and rates (`phi'`) by name; none leaves the start open, at rest.
    pub start: Vec<(String, f64)>,
    /// Parameters by name.
    pub parameters: Vec<(String, f64)>,
}

/// When each reaction of a contact set vanishes.
#[derive(Clone, Debug)]
pub struct Conditions {
    /// The contact set, as its equations are headed.
    pub phase: String,
    /// q.
    pub coordinate: Math,
    /// q̇² and q̈ on the energy level.
    pub motion: Vec<Equation>,
    /// One for each one-sided contact.
    pub reactions: Vec<Condition>,
    /// One for each two of them.
    pub pairs: Vec<Coincidence>,
    /// For the parameters and the start that are given.
    pub numbers: Option<Numbers>,
}

/// A reaction as a function of the coordinate.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The contact.
    pub label: String,
    /// `N(A, E) = N(A) + N(E)` where it has several supports.
    pub total: Option<Equation>,
    /// `N = …`.
    pub reaction: Equation,
    /// `0 = …`, without factors that have one sign for all positive parameters; none of a reaction
    /// that never vanishes.
    pub vanishes: Option<Equation>,
    /// It has a double root where one of these holds, for positive parameters; `None` where the
    /// discriminant is too long.
    pub double: Option<Vec<Equation>>,
}

/// What two reactions have to do with each other.
#[derive(Clone, Debug)]
pub struct Coincidence {
    /// The contacts.
    pub labels: [String; 2],
    /// Where the first of each holds, one reaction is a multiple of the other: `m₁ = 3 m₂`,
    /// `N(C) = 3 N(A, E)`.
    pub proportional: Vec<(Equation, Option<Equation>)>,
    /// Whether it is a multiple for all parameters.
    pub always: Option<Equation>,
    /// Both vanish at one position where one of these holds; `None` where the resultant is too
    /// long.
    pub together: Option<Vec<Equation>>,
}

impl Conditions {
    /// Those of the contact set with these supports closed, `A, E`.
    ///
    /// # Errors
    /// No such contact set; more than one degree of freedom; energy that is not conserved; no
    /// reaction; a start or parameters that it does not have.
    pub fn derive(analysis: &Analysis, supports: &str, request: &Request) -> Result<Self, ConditionError> {
        Self::of_phase(analysis, crate::phase::find(analysis, supports)?, request)
    }

    pub(crate) fn of_phase(
        analysis: &Analysis,
        phase: &Phase,
        request: &Request,
    ) -> Result<Self, ConditionError> {
        let named = Named::new(analysis, phase);
        let coordinate = named.single_coordinate()?;
        let begin = Begin::from_request(&named, coordinate, request)?;
        let level = Level::derive(analysis, phase, begin.start())?;
        let functions = Functions::new(&named, &level);
        Ok(Self {
            phase: named.title(),
            coordinate: functions.symbol(0),
            motion: functions.motion(),
            reactions: functions.conditions(),
            pairs: functions.pairs(),
            numbers: begin
                .place
                .map(|place| functions.numbers(coordinate, request, &place, begin.rate))
                .transpose()?,
        })
    }
}
