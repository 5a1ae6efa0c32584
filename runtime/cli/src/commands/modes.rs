//! `liftoff modes`.

use crate::CommandError;
use crate::output::file::{Form, probe_as, tell_written, write_picture};
use crate::output::print::print;
use clap::Args;
use liftoff_studio::modes::svg;
use liftoff_studio::registry::Models;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct Modes {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
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
        let modes = model.modes(&model.default_run())?;
        if let Some(path) = &self.svg {
            probe_as(path, &[Form::SVG])?;
            write_picture(path, &svg(&modes))?;
            tell_written(path);
            return Ok(());
        }
        Ok(print(&if self.dot { modes.dot() } else { modes.to_string() })?)
    }
}
