//! `liftoff sensitivity`.

use crate::CommandError;
use crate::options::run_args::RunArgs;
use crate::output::notes::note;
use crate::output::print::print;
use crate::output::sensitivity;
use clap::Args;
use liftoff_studio::analyses::differentiate;
use liftoff_studio::registry::{Models, RunOptions};

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
        let found = differentiate(model, RunOptions::default(), &spec, &self.of)
            .map_err(|failure| CommandError::with_option("--of", failure))?;
        found.left_out.iter().for_each(|text| note(text));
        Ok(print(&match self.json {
            true => sensitivity::json(&found)?,
            false => sensitivity::text(&found),
        })?)
    }
}
