//! `liftoff export`.

use crate::CommandError;
use crate::output::file::{self, unwritable};
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
    /// Write a library of C99 to a folder: a header, a source and a makefile; functions of each contact set
    #[arg(long, value_name = "FOLDER", group = "target")]
    c: Option<PathBuf>,
}

impl Export {
    /// Writes the equations of the model in each form that is asked for.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let layout = models.find(&self.model)?.layout();
        if let Some(path) = &self.sympy {
            write(path, &export::sympy(layout).map_err(CommandError::Failed)?)?;
        }
        if let Some(folder) = &self.c {
            let files = export::c(layout).map_err(CommandError::Failed)?;
            std::fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error))?;
            files.iter().try_for_each(|file| write(&folder.join(&file.name), &file.text))?;
        }
        Ok(())
    }
}

fn write(path: &Path, text: &str) -> Result<(), CommandError> {
    file::write(path, text).map(|()| file::tell_written(path))
}
