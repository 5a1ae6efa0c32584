//! `liftoff conditions`.

use crate::CommandError;
use crate::commands::explain::{Format, Target};
use crate::options::run_args::checked;
use crate::options::values::{Assignment, assignment};
use clap::Args;
use liftoff_studio::explain::conditions::{Request, conditions, latex, page, text};
use liftoff_studio::registry::{Models, Place};
use liftoff_studio::run_spec::overridden;

#[derive(Args, Debug)]
pub struct Conditions {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    /// Only the phase with these supports closed (`A, E`), or `free`
    #[arg(long, value_name = "SUPPORTS")]
    phase: Option<String>,
    /// A coordinate or rate (`phi'`) at the start, for its energy; without it the motion starts at rest anywhere
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    from: Vec<Assignment>,
    /// A parameter
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    set: Vec<Assignment>,
    #[command(flatten)]
    target: Target,
}

impl Conditions {
    /// Prints or writes when each reaction vanishes, as a formula, and what stays constant.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let format = self.target.format()?;
        let model = models.find(&self.model)?;
        let request = Request {
            start: checked(model, Place::Start, &self.from)?,
            parameters: overridden(
                model.default_run().parameters,
                &checked(model, Place::Parameter, &self.set)?,
            ),
        };
        let layout = model.layout();
        let sections = conditions(layout, self.phase.as_deref(), &request).map_err(CommandError::Usage)?;
        let written = match format {
            Format::Text => text(layout.name, &sections),
            Format::Latex => latex(layout.name, &sections),
            Format::Html => page(layout.name, &sections),
        };
        self.target.write(&written)
    }
}
