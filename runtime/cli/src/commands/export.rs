//! `liftoff export`.

use crate::CommandError;
use crate::output::file;
use clap::Args;
use liftoff_studio::explain::export;
use liftoff_studio::registry::Models;
use std::path::{Path, PathBuf};

#[derive(Args, Debug)]
#[command(group = clap::ArgGroup::new("target").required(true).multiple(true))]
pub struct Export {
    /// Name of the model, as `list` has it; or a file of Rust, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    /// Write a module of Python: symbols, matrices and expressions of each contact set for SymPy
    #[arg(long, value_name = "FILE", group = "target")]
    sympy: Option<PathBuf>,
}

impl Export {
    /// Writes the equations of the model in each form that is asked for.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let layout = models.find(&self.model)?.layout();
        if let Some(path) = &self.sympy {
            write(path, &export::sympy(layout).map_err(CommandError::Failed)?)?;
        }
        Ok(())
    }
}

fn write(path: &Path, text: &str) -> Result<(), CommandError> {
    file::write(path, text).map(|()| file::tell_written(path))
}
