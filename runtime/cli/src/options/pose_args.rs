//! Parameters and a position, of a run or of an analysis.

use crate::CommandError;
use crate::options::run_args::checked;
use crate::options::values::{Assignment, assignment};
use clap::Args;
use liftoff_studio::registry::{Entry, Place};
use liftoff_studio::run_spec::{RunSpec, Values, overridden};

#[derive(Args, Clone, Debug)]
pub struct PoseArgs {
    /// A parameter
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    pub set: Vec<Assignment>,
    /// A coordinate or rate (`phi'`) at the start, or its time, `t`; replaces the default start
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    pub start: Vec<Assignment>,
}

impl PoseArgs {
    /// The position that is given, or else the default start.
    pub fn spec(&self, model: &Entry) -> Result<RunSpec, CommandError> {
        let (start, default) = (checked(model, Place::Start, &self.start)?, model.default_run());
        let start = if start.is_empty() { default.start } else { start };
        Ok(RunSpec { parameters: self.parameters(model)?, start, ..default })
    }

    /// The values of the parameters, those of the default run where none is given.
    pub fn parameters(&self, model: &Entry) -> Result<Values, CommandError> {
        let given = checked(model, Place::Parameter, &self.set)?;
        Ok(overridden(model.default_run().parameters, &given))
    }
}
