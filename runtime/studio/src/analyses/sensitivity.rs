//! Derivatives of runs.

use super::variables::{all, variables, with_value};
use super::{Failure, equations};
use crate::registry::{Entry, RunOptions};
use crate::run_spec::RunSpec;
use liftoff::Trajectory;
use liftoff_analysis::{Sensitivities, SensitivityError, Variable};
use liftoff_core::scalar::Dual4;

/// A run with its derivatives.
pub struct DifferentiatedRun {
    /// The run.
    pub run: Trajectory,
    /// What it is differentiated with respect to.
    pub variables: Vec<Variable>,
    /// The derivatives.
    pub sensitivities: Sensitivities,
    /// Why the start cannot be varied with others, where none was asked for by name.
    pub left_out: Vec<String>,
}

/// Differentiates a run with respect to these parameters and entries of its start, by default to
/// all with which the start can be varied.
///
/// # Errors
/// The run is refused or stops short; unknown names; the run has no derivatives.
pub fn differentiate(
    model: &Entry,
    options: RunOptions,
    spec: &RunSpec,
    names: &[String],
) -> Result<DifferentiatedRun, Failure> {
    let simulation = model.simulation_by(options, spec)?;
    let run = simulation.run().map_err(|error| Failure::NotFound(error.to_string()))?;
    let by_default = names.is_empty();
    let names = if by_default { all(&simulation, spec) } else { names.to_vec() };
    let mut variables = variables(&simulation, spec, &names)?;
    let start = |variable: &Variable, value: f64| {
        let simulation = model.simulation(&with_value(spec, variable, value));
        let simulation = simulation.map_err(|error| error.to_string())?;
        simulation.start_state().map_err(|error| error.to_string())
    };
    let mut left_out = Vec::new();
    loop {
        let found =
            Sensitivities::compute(&run, |values: &[Dual4]| equations(model, values), &variables, start);
        match found {
            Ok(sensitivities) => return Ok(DifferentiatedRun { run, variables, sensitivities, left_out }),
            Err(error @ SensitivityError::Start { .. }) if by_default && variables.len() > 1 => {
                left_out.push(error.to_string());
                let SensitivityError::Start { variable, .. } = error else { continue };
                variables.retain(|of| of.name != variable);
            }
            Err(error) => return Err(Failure::NotFound(error.to_string())),
        }
    }
}
