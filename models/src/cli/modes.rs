//! `liftoff modes`.

use super::CommandError;
use super::print::print;
use crate::catalog::find;
use clap::Args;

#[derive(Args, Debug)]
pub struct Modes {
    /// Name of the model, see `liftoff list`
    model: String,
    /// Print a graph for Graphviz
    #[arg(long)]
    dot: bool,
}

impl Modes {
    /// Prints the contact sets of the model with its default parameters.
    pub fn execute(&self) -> Result<(), CommandError> {
        let modes = find(&self.model)?.modes()?;
        Ok(print(&if self.dot { modes.dot() } else { modes.to_string() })?)
    }
}
