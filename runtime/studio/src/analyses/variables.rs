//! Parameters, and what is given at the start, as what runs are varied with.

use crate::run_spec::RunSpec;
use liftoff::__private::expression::normalize_rate;
use liftoff::Simulation;
use liftoff_analysis::{OptimumError, Variable};

/// Why something cannot be varied.
#[derive(thiserror::Error, Debug)]
pub enum VariableError {
    /// It is named more than once.
    #[error("`{0}` is given twice")]
    Twice(String),
    /// It has no value.
    #[error("{name}: neither a parameter nor given at the start; there are {}", .known.join(", "))]
    Unknown {
        /// Its name.
        name: String,
        /// What can be varied.
        known: Vec<String>,
    },
    /// It does not begin between its bounds.
    #[error(transparent)]
    Outside(OptimumError),
}

/// The names of all.
pub(super) fn all(simulation: &Simulation, spec: &RunSpec) -> Vec<String> {
    let layout = simulation.layout();
    let parameters = layout.parameters.iter().map(|name| (*name).to_owned());
    // `below(P)` is no value.
    let is_value = |name: &String| layout.names_of_motion().any(|known| known == *name);
    parameters.chain(spec.start.iter().map(|(name, _)| name.clone()).filter(is_value)).collect()
}

/// Those of these names.
pub(super) fn variables(
    simulation: &Simulation,
    spec: &RunSpec,
    names: &[String],
) -> Result<Vec<Variable>, VariableError> {
    let twice = names.iter().enumerate().find(|(k, name)| names[..*k].contains(name));
    if let Some((_, name)) = twice {
        return Err(VariableError::Twice(name.clone()));
    }
    let layout = simulation.layout();
    let variable = |name: &String| {
        let parameter = layout.parameters.iter().position(|parameter| parameter == name);
        let given = spec.start.iter().find(|(given, _)| given == name).map(|(_, value)| *value);
        let value = parameter.map(|i| simulation.model().parameters[i]).or(given);
        let unknown = || VariableError::Unknown { name: name.clone(), known: all(simulation, spec) };
        let value = value.ok_or_else(unknown)?;
        let unit = match parameter {
            Some(_) if value != 0.0 => value.abs(),
            Some(_) => 1.0,
            None => natural(simulation, name),
        };
        Ok(Variable { name: name.clone(), parameter, value, unit })
    };
    names.iter().map(|name| variable(&normalize_rate(name).into_owned())).collect()
}

/// The natural unit of a coordinate or rate.
fn natural(simulation: &Simulation, name: &str) -> f64 {
    let layout = simulation.layout();
    let coordinate = name.trim_end_matches('\'');
    let place = |name: &str| layout.coordinates.iter().position(|known| known.name == name);
    // A dependent angle has the unit of those that it follows.
    let followed = || {
        let angle = layout.dependent.iter().find(|angle| angle.name == coordinate)?;
        angle.coordinates.first().map(|term| term.index)
    };
    let index = place(coordinate).or_else(followed).unwrap_or(0);
    let rate = if coordinate == name { 0 } else { layout.coordinates.len() };
    simulation.scales().state(layout)[index + rate]
}

/// The run with these values of variables.
pub(super) fn with_values(spec: &RunSpec, variables: &[Variable], values: &[f64]) -> RunSpec {
    let each = variables.iter().zip(values);
    each.fold(spec.clone(), |spec, (variable, value)| with_value(&spec, variable, *value))
}

/// The run with another value of a variable.
pub(super) fn with_value(spec: &RunSpec, variable: &Variable, value: f64) -> RunSpec {
    let mut spec = spec.clone();
    let values = if variable.parameter.is_some() { &mut spec.parameters } else { &mut spec.start };
    values.iter_mut().filter(|(name, _)| *name == variable.name).for_each(|(_, old)| *old = value);
    spec
}
