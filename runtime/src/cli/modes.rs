//! `liftoff modes`.

use super::CommandError;
use super::print::print;
use crate::catalog::Models;
use crate::plot::on_card;
use clap::Args;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct Modes {
    /// Name of the model, as `list` has it
    model: String,
    /// Print a graph for Graphviz
    #[arg(long)]
    dot: bool,
    /// Draw the graph into a file
    #[arg(long, value_name = "FILE", conflicts_with = "dot")]
    svg: Option<PathBuf>,
}

impl Modes {
    /// Prints or draws the contact sets of the model with its default parameters.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let modes = model.modes(&model.setup())?;
        if let Some(path) = &self.svg {
            let failed = |error| CommandError::Failed(format!("cannot write {}: {error}", path.display()));
            return std::fs::write(path, on_card(&modes.svg())).map_err(failed);
        }
        Ok(print(&if self.dot { modes.dot() } else { modes.to_string() })?)
    }
}
