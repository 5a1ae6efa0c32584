//! Parameters and a position, of a run or of an analysis.

use crate::CommandError;
use crate::options::run_args::checked;
use crate::options::values::{Assignment, assignment};
use clap::Args;
use liftoff_analysis::Subject;
use liftoff_studio::registry::{Entry, MotionError, Place};
use liftoff_studio::run_spec::{RunSpec, Values, overridden};

#[derive(Args, Clone, Debug)]
pub struct PoseArgs {
    /// A parameter
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    pub set: Vec<Assignment>,
    /// A coordinate or rate (`phi'`) at the start; replaces the default start
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    pub start: Vec<Assignment>,
}

impl PoseArgs {
    /// The model at the position that is given, or else at its default start.
    pub fn subject(&self, model: &Entry) -> Result<Subject, CommandError> {
        let start = checked(model, Place::Start, &self.start)?;
        let start = if start.is_empty() { model.default_run().start } else { start };
        subject(model, self.parameters(model)?, start)
    }

    /// The values of the parameters, those of the default run where none is given.
    pub fn parameters(&self, model: &Entry) -> Result<Values, CommandError> {
        let given = checked(model, Place::Parameter, &self.set)?;
        Ok(overridden(model.default_run().parameters, &given))
    }

    /// The value of a parameter that the model has.
    pub fn parameter(&self, model: &Entry, name: &str) -> Result<f64, CommandError> {
        let all = self.parameters(model)?;
        let value = all.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
        value.ok_or_else(|| CommandError::Usage(format!("parameter `{name}` is not given")))
    }
}

/// A model with these parameters at this position.
pub fn subject(model: &Entry, parameters: Values, start: Values) -> Result<Subject, CommandError> {
    let spec = RunSpec { parameters, start, energy_of: Vec::new(), ..model.default_run() };
    let precise = model.precise(&spec.parameters)?;
    Subject::new(&model.simulation(&spec)?, precise)
        .map_err(|error| MotionError::Input(error.to_string()).into())
}
