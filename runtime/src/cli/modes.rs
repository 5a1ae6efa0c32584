//! `liftoff modes`.

use super::CommandError;
use super::print::print;
use crate::catalog::Models;
use clap::Args;

#[derive(Args, Debug)]
pub struct Modes {
    /// Name of the model, as `list` has it
    model: String,
    /// Print a graph for Graphviz
    #[arg(long)]
    dot: bool,
}

impl Modes {
    /// Prints the contact sets of the model with its default parameters.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let modes = model.modes(&model.setup())?;
        Ok(print(&if self.dot { modes.dot() } else { modes.to_string() })?)
    }
}
