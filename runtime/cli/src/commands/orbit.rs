//! `liftoff orbit`.

use crate::CommandError;
use crate::options::run_args::RunArgs;
use crate::options::values::{Assignment, assignment};
use crate::output::orbit;
use crate::output::print::print;
use clap::Args;
use liftoff_studio::analyses::{Failure, Orbits, find_parameter};
use liftoff_studio::registry::{Models, RunOptions, Units};

#[derive(Args, Debug)]
pub struct Orbit {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// The section, met once per period: an event, `impact` or `impact A`, or a condition that
    /// becomes true, `phi' > 0`; for a driven model `t = T` with the period of its drive
    #[arg(long, value_name = "EVENT|EXPR")]
    section: String,
    /// A coordinate that need not return, such as the distance walked
    #[arg(long, value_name = "NAME")]
    drift: Vec<String>,
    /// A parameter in which to continue the orbit, and its final value
    #[arg(long = "continue", value_name = "NAME=VALUE", value_parser = assignment)]
    to: Option<Assignment>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Orbit {
    /// Prints the periodic orbit near the run, its multipliers, and its branch where a parameter is given.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let layout = model.layout();
        let run = (RunOptions::default(), self.run_args.spec(model)?);
        let orbits = Orbits::new(model, run, &self.section, &self.drift)?;
        let found = orbits.find()?;
        let Some(to) = &self.to else {
            return Ok(print(&match self.json {
                true => orbit::json(layout, &found)?,
                false => orbit::text(layout, &found),
            })?);
        };
        Units::from_layout(layout)
            .check(&to.name, to.unit)
            .map_err(|why| CommandError::Usage(format!("--continue {}: {why}", to.name)))?;
        let place = find_parameter(layout, &to.name).map_err(Failure::from)?;
        let branch = orbits.follow(&found, place, to.value)?;
        Ok(print(&match self.json {
            true => orbit::branch_json(layout, &branch)?,
            false => orbit::branch_text(layout, &branch, place),
        })?)
    }
}
