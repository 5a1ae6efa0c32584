//! `liftoff sensitivity`.

use crate::CommandError;
use crate::options::run_args::RunArgs;
use crate::output::notes::note;
use crate::output::print::print;
use crate::output::sensitivity;
use clap::Args;
use liftoff::scalar::Dual4;
use liftoff::{Simulation, Trajectory};
use liftoff_analysis::{Sensitivities, SensitivityError, Variable};
use liftoff_studio::registry::{Entry, Models, MotionError};
use liftoff_studio::run_spec::RunSpec;

#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  sensitivity falling-pair                       by all parameters and what is given at the start
  sensitivity zigzag --of m1 --of phi_inner      by these two")]
pub struct Sensitivity {
    /// Name of the model, as `list` has it; or a file of Rust, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// A parameter, or a coordinate or rate given at the start; by default all of them
    #[arg(long, value_name = "NAME")]
    of: Vec<String>,
    /// Print JSON, with the derivatives of the states at the events too
    #[arg(long)]
    json: bool,
}

impl Sensitivity {
    /// Prints the derivatives of the times of the events, and of the state at the end.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let spec = self.run_args.spec(model)?;
        let simulation = model.simulation(&spec)?;
        let run = simulation.run().map_err(|error| CommandError::Failed(error.to_string()))?;
        let variables = self.variables(&simulation, &spec)?;
        let (variables, found) = self.differentiated(model, &spec, &run, variables)?;
        Ok(print(&match self.json {
            true => sensitivity::json(&run, &variables, &found)?,
            false => sensitivity::text(&run, &variables, &found),
        })?)
    }

    /// Of all variables; where none is asked for by name, without those that the start cannot be varied with.
    fn differentiated(
        &self,
        model: &Entry,
        spec: &RunSpec,
        run: &Trajectory,
        mut variables: Vec<Variable>,
    ) -> Result<(Vec<Variable>, Sensitivities), CommandError> {
        let equations = |parameters: &[Dual4]| model.varied(parameters).map_err(|error| error.to_string());
        let start = |variable: &Variable, value: f64| {
            start(model, spec, variable, value).map_err(|error| error.to_string())
        };
        loop {
            match Sensitivities::of(run, equations, &variables, start) {
                Ok(found) => return Ok((variables, found)),
                Err(error @ SensitivityError::Start { .. }) if self.of.is_empty() && variables.len() > 1 => {
                    note(&error.to_string());
                    let SensitivityError::Start { variable, .. } = error else { continue };
                    variables.retain(|of| of.name != variable);
                }
                Err(error) => return Err(CommandError::Failed(error.to_string())),
            }
        }
    }

    fn variables(&self, simulation: &Simulation, spec: &RunSpec) -> Result<Vec<Variable>, CommandError> {
        let layout = simulation.layout();
        let all =
            || layout.parameters.iter().copied().chain(spec.start.iter().map(|(name, _)| name.as_str()));
        let names: Vec<&str> =
            if self.of.is_empty() { all().collect() } else { self.of.iter().map(String::as_str).collect() };
        let variable = |name: &str| {
            let parameter = layout.parameters.iter().position(|parameter| *parameter == name);
            let given = spec.start.iter().find(|(given, _)| given == name).map(|(_, value)| *value);
            let value = parameter.map(|i| simulation.model().parameters[i]).or(given);
            let value = value.ok_or_else(|| {
                let known = all().collect::<Vec<_>>().join(", ");
                CommandError::Usage(format!(
                    "--of {name}: neither a parameter nor given at the start; there are {known}; --start '{name}=…' gives it"
                ))
            })?;
            let unit = match parameter {
                Some(_) if value != 0.0 => value.abs(),
                Some(_) => 1.0,
                None => natural(simulation, name),
            };
            Ok(Variable { name: name.to_owned(), parameter, value, unit })
        };
        names.into_iter().map(variable).collect()
    }
}

/// The natural unit of a coordinate or rate.
fn natural(simulation: &Simulation, name: &str) -> f64 {
    let layout = simulation.layout();
    let coordinate = name.trim_end_matches('\'');
    let index = layout.coordinates.iter().position(|known| known.name == coordinate).unwrap_or(0);
    let rate = if coordinate == name { 0 } else { layout.coordinates.len() };
    simulation.scales().state(layout)[index + rate]
}

/// The full state of the start with another value of a variable.
fn start(model: &Entry, spec: &RunSpec, variable: &Variable, value: f64) -> Result<Vec<f64>, MotionError> {
    let mut spec = spec.clone();
    let values = if variable.parameter.is_some() { &mut spec.parameters } else { &mut spec.start };
    let given = values.iter_mut().filter(|(name, _)| *name == variable.name);
    given.for_each(|(_, old)| *old = value);
    let simulation = model.simulation(&spec)?;
    simulation.start_state().map_err(|error| MotionError::Input(error.to_string()))
}
