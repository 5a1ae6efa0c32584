//! Parameters, and what is given at the start, as what runs are varied with.

use crate::CommandError;
use liftoff::__private::expression::normalize_rate;
use liftoff::Simulation;
use liftoff_analysis::Variable;
use liftoff_studio::run_spec::RunSpec;

/// The names of all.
pub fn all(simulation: &Simulation, spec: &RunSpec) -> Vec<String> {
    let layout = simulation.layout();
    let parameters = layout.parameters.iter().map(|name| (*name).to_owned());
    // `below(P)` is no value.
    let is_value = |name: &String| layout.names_of_motion().any(|known| known == *name);
    parameters.chain(spec.start.iter().map(|(name, _)| name.clone()).filter(is_value)).collect()
}

/// Those of these names, which an option has.
pub fn variables(
    simulation: &Simulation,
    spec: &RunSpec,
    option: &str,
    names: &[String],
) -> Result<Vec<Variable>, CommandError> {
    let twice = names.iter().enumerate().find(|(k, name)| names[..*k].contains(name));
    if let Some((_, name)) = twice {
        return Err(CommandError::Usage(format!("{option}: `{name}` is given twice")));
    }
    let layout = simulation.layout();
    let variable = |name: &String| {
        let parameter = layout.parameters.iter().position(|parameter| parameter == name);
        let given = spec.start.iter().find(|(given, _)| given == name).map(|(_, value)| *value);
        let value = parameter.map(|i| simulation.model().parameters[i]).or(given);
        let value = value.ok_or_else(|| {
            let known = all(simulation, spec).join(", ");
            CommandError::Usage(format!(
                "{option} {name}: neither a parameter nor given at the start; there are {known}; --start '{name}=…' gives it"
            ))
        })?;
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
pub fn with_values(spec: &RunSpec, variables: &[Variable], values: &[f64]) -> RunSpec {
    let each = variables.iter().zip(values);
    each.fold(spec.clone(), |spec, (variable, value)| with_value(&spec, variable, *value))
}

/// The run with another value of a variable.
pub fn with_value(spec: &RunSpec, variable: &Variable, value: f64) -> RunSpec {
    let mut spec = spec.clone();
    let values = if variable.parameter.is_some() { &mut spec.parameters } else { &mut spec.start };
    values.iter_mut().filter(|(name, _)| *name == variable.name).for_each(|(_, old)| *old = value);
    spec
}
