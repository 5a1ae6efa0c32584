//! `liftoff equilibrium`.

use crate::CommandError;
use crate::options::pose_args::PoseArgs;
use crate::output::analysis;
use crate::output::print::print;
use clap::Args;
use liftoff_analysis::equilibria;
use liftoff_studio::registry::Models;

#[derive(Args, Debug)]
pub struct Equilibrium {
    /// Name of the model, as `list` has it; or a file of Rust, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    pose: PoseArgs,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Equilibrium {
    /// Prints the equilibria that are found from the start, each with its reactions and its modes of vibration.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let subject = self.pose.subject(models.find(&self.model)?)?;
        let found = equilibria(&subject)?;
        let layout = subject.layout();
        Ok(print(&match self.json {
            true => analysis::equilibria_json(layout, &found)?,
            false => analysis::equilibria_text(layout, &found),
        })?)
    }
}
