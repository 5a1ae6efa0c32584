//! Parameters and a position, of a run or of an analysis.

use crate::CommandError;
use crate::options::run_args::checked;
use crate::options::values::{Assignment, assignment};
use clap::Args;
use liftoff_analysis::Subject;
use liftoff_studio::registry::{Entry, MotionError, Place};
use liftoff_studio::run_spec::{RunSpec, overridden};

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
        let default = model.default_run();
        let [set, start] = [(Place::Parameter, &self.set), (Place::Start, &self.start)]
            .map(|(place, given)| checked(model, place, given));
        let (set, start) = (set?, start?);
        let start = if start.is_empty() { default.start.clone() } else { start };
        let parameters = overridden(default.parameters.clone(), &set);
        let spec = RunSpec { parameters, start, energy_of: Vec::new(), ..default };
        let precise = model.precise(&spec.parameters)?;
        Subject::new(&model.simulation(&spec)?, precise)
            .map_err(|error| MotionError::Input(error.to_string()).into())
    }
    /// The value of a parameter that the model has.
    pub fn parameter(&self, model: &Entry, name: &str) -> Result<f64, CommandError> {
        let given = checked(model, Place::Parameter, &self.set)?;
        let all = overridden(model.default_run().parameters, &given);
        let value = all.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
        value.ok_or_else(|| CommandError::Usage(format!("parameter `{name}` is not given")))
    }
}
