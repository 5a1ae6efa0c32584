//! `liftoff sensitivity`.

use crate::CommandError;
use crate::options::run_args::RunArgs;
use crate::options::variables::{all, variables, with_value};
use crate::output::notes::note;
use crate::output::print::print;
use crate::output::sensitivity;
use clap::Args;
use liftoff::Trajectory;
use liftoff_analysis::{Sensitivities, SensitivityError, Variable};
use liftoff_core::scalar::Dual4;
use liftoff_studio::registry::{Entry, Models};
use liftoff_studio::run_spec::RunSpec;

#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  sensitivity falling-pair                       by all parameters and what is given at the start
  sensitivity zigzag --of m1 --of phi_inner      by these two")]
pub struct Sensitivity {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// A parameter, coordinate or rate at the start [default: all]
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
        let names = if self.of.is_empty() { all(&simulation, &spec) } else { self.of.clone() };
        let variables = variables(&simulation, &spec, "--of", &names)?;
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
            let simulation = model.simulation(&with_value(spec, variable, value));
            let simulation = simulation.map_err(|error| error.to_string())?;
            simulation.start_state().map_err(|error| error.to_string())
        };
        loop {
            match Sensitivities::compute(run, equations, &variables, start) {
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
}
