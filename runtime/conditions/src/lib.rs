//! Lift-off conditions in closed form: when which contact opens, as a formula.
//!
//! A contact set of one degree of freedom conserves its energy, `½ M̂(q) q̇² + V(q) = h`; that
//! gives q̇² and q̈ as functions of the coordinate q, and so every reaction: `N(q; q₀)` is a
//! rational function of sin q and cos q, and its numerator the condition of lift-off.
//! [`Conditions`] has these for every contact of a set; with exact algebra it finds for which
//! parameters two of them vanish together, are multiples of each other, or touch zero, and with
//! exact arithmetic where they vanish for given ones. [`FirstIntegrals`] are what stays constant in
//! a contact set of any number of degrees of freedom.
//!
//! ```text
//! Analysis → Level → Form → Condition, Coincidence → Section
//!            level   algebra  conditions             statement
//!                    Form → Numbers
//!                           numeric
//! ```
//!
//! - `phase`: contact sets by name, and what in them conserves no energy; `level`: the energy
//!   level.
//! - `algebra`: rational functions, greatest common divisors, resultants; `numeric`: real roots
//!   with certainty.
//! - `conditions`: from the level to its conditions; `integrals`: first integrals.
//! - `written`: rational functions as they are written; `statement`: what is said of them.

mod algebra;
mod conditions;
mod error;
mod integrals;
mod level;
mod numeric;
mod phase;
mod statement;
mod written;

use liftoff_codegen::Analysis;
use liftoff_codegen::motion::ClosedSet;
use liftoff_codegen::phases::Phase;

pub use conditions::{Coincidence, Condition, Conditions, Request};
pub use error::ConditionError;
pub use integrals::{Integral, Kind};
pub use numeric::zeros::{First, Numbers, Stationary, Zero};
pub use statement::{Piece, Section, Statement};

/// What stays constant in a contact set.
#[derive(Clone, Debug)]
pub struct FirstIntegrals {
    /// The contact set, as its equations are headed.
    pub phase: String,
    /// Its contacts.
    pub set: ClosedSet,
    /// All that are found.
    pub integrals: Vec<Integral>,
}

/// The first integrals of every contact set in closed form.
pub fn first_integrals(analysis: &Analysis) -> Vec<FirstIntegrals> {
    analysis.phases.iter().map(|phase| of_phase(analysis, phase)).collect()
}

fn of_phase(analysis: &Analysis, phase: &Phase) -> FirstIntegrals {
    let title = phase::Named::new(analysis, phase).title();
    FirstIntegrals { phase: title, set: phase.set, integrals: integrals::find_integrals(analysis, phase) }
}

/// All that is said of a model: the conditions of every contact set that has some, and its first
/// integrals; of one set where it is named.
///
/// # Errors
/// As [`Conditions::derive`], of the set that is named, or where none is and a start is given that
/// fits no set.
pub fn sections(
    analysis: &Analysis,
    supports: Option<&str>,
    request: &Request,
) -> Result<Vec<Section>, ConditionError> {
    if let Some(supports) = supports {
        let phase = phase::find(analysis, supports)?;
        let mut section = Conditions::of_phase(analysis, phase, request)?.section();
        section.statements.extend(of_phase(analysis, phase).section().statements);
        return Ok(vec![section]);
    }
    let mut refused = Vec::new();
    let mut found = 0;
    let sections = analysis.phases.iter().map(|phase| {
        let mut section = of_phase(analysis, phase).section();
        match Conditions::of_phase(analysis, phase, request) {
            Ok(conditions) => {
                found += 1;
                section.statements.splice(..0, conditions.section().statements);
            }
            Err(error) => refused.push(error),
        }
        section
    });
    let mut sections: Vec<Section> = sections.collect();
    sections.retain(|section| !section.statements.is_empty());
    // A start, or a parameter, that suits no contact set.
    match refused.into_iter().find(ConditionError::is_of_request) {
        Some(error) if found == 0 && request != &Request::default() => Err(error),
        _ if sections.is_empty() => Err(ConditionError::Nothing),
        _ => Ok(sections),
    }
}
