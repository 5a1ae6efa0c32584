//! Where a model rests.

use super::{Failure, find_parameter};
use crate::registry::{Entry, input, missing_parameter};
use crate::run_spec::{RunSpec, overridden};
use liftoff_analysis::{AnalysisError, Equilibrium, LoadLimit, Subject, equilibria, load_limit};

/// An equilibrium, and how far a load may go there.
pub struct Rest {
    /// Where it is, and what the contacts bear.
    pub equilibrium: Equilibrium,
    /// The end of the load; none where none was asked for, or it may go as far as it was followed.
    pub limit: Option<LoadLimit>,
}

/// The model at the start of a run, at rest.
///
/// # Errors
/// Parameters or a start that it does not have, or that are not given.
pub fn subject(model: &Entry, spec: &RunSpec) -> Result<Subject, Failure> {
    let precise = model.precise(&spec.parameters)?;
    let simulation = model.simulation(&RunSpec { energy_of: Vec::new(), ..spec.clone() })?;
    Ok(Subject::new(&simulation, precise).map_err(input)?)
}

/// The equilibria that are found from the start of a run, each with how far a parameter may go
/// towards a value.
///
/// # Errors
/// As for [`subject`]; an unknown parameter; no equilibrium is found.
pub fn find_equilibria(
    model: &Entry,
    spec: &RunSpec,
    load: Option<(&str, f64)>,
) -> Result<Vec<Rest>, Failure> {
    if let Some((name, _)) = load {
        find_parameter(model.layout(), name)?;
    }
    let each = equilibria(&subject(model, spec)?)?.into_iter().map(|equilibrium| {
        let limit = load.map(|load| find_limit(model, spec, &equilibrium, load));
        Ok(Rest { limit: limit.transpose()?.flatten(), equilibrium })
    });
    each.collect()
}

fn find_limit(
    model: &Entry,
    spec: &RunSpec,
    rest: &Equilibrium,
    (name, to): (&str, f64),
) -> Result<Option<LoadLimit>, Failure> {
    let from = spec.parameters.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
    let from = from.ok_or_else(|| Failure::Input(missing_parameter(name)))?;
    let with = |value: f64| {
        let parameters = overridden(spec.parameters.clone(), &[(name.to_owned(), value)]);
        let moved = subject(model, &RunSpec { parameters, ..spec.clone() });
        moved.map_err(|error| AnalysisError::Value { value, why: error.to_string() })
    };
    Ok(load_limit(&with, rest, [from, to])?)
}
