//! `liftoff export`.

use crate::CommandError;
use crate::output::file::{self, Form, check_folder, check_form, unwritable};
#[cfg(feature = "fmu")]
use crate::output::notes::note;
use clap::Args;
use liftoff_studio::explain::export;
use liftoff_studio::registry::{Entry, Models};
use std::path::{Path, PathBuf};

#[derive(Args, Debug)]
#[command(group = clap::ArgGroup::new("target").required(true).multiple(true))]
pub struct Export {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    /// Write a module of Python: symbols, matrices and expressions of each contact set for SymPy
    #[arg(long, value_name = "FILE", group = "target")]
    sympy: Option<PathBuf>,
    /// Write a library of C99 to a folder: a header, a source and a makefile; functions of each contact set
    #[arg(long, value_name = "FOLDER", group = "target")]
    c: Option<PathBuf>,
    /// Write a functional mock-up unit of FMI 3.0, for model exchange and co-simulation (of programs built with feature `fmu`)
    #[arg(long, value_name = "FILE", group = "target")]
    fmu: Option<PathBuf>,
    /// The shared library that goes into the unit; by default the one beside this program
    #[arg(long, value_name = "FILE", requires = "fmu")]
    library: Option<PathBuf>,
}

impl Export {
    /// Writes the equations of the model in each form that is asked for.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let layout = model.layout();
        self.sympy.iter().try_for_each(|path| check_form(path, &[Form::PYTHON]))?;
        self.c.iter().try_for_each(|folder| check_folder(folder))?;
        self.fmu.iter().try_for_each(|path| check_form(path, &[Form::FMU]))?;
        if let Some(path) = &self.sympy {
            write(path, &export::sympy(layout).map_err(CommandError::Failed)?)?;
        }
        if let Some(folder) = &self.c {
            let files = export::c(layout).map_err(CommandError::Failed)?;
            std::fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error))?;
            files.iter().try_for_each(|file| write(&folder.join(&file.name), &file.text))?;
        }
        self.fmu.iter().try_for_each(|path| self.unit(model, path))
    }

    #[cfg(feature = "fmu")]
    fn unit(&self, model: &Entry, path: &Path) -> Result<(), CommandError> {
        let library = self.library.clone().unwrap_or_else(liftoff_fmu::library_beside_program);
        let unit = liftoff_fmu::write(model, &library);
        let unit = unit.map_err(|error| CommandError::Failed(error.to_string()))?;
        if let Some(lacks) = liftoff_fmu::exchange_lacks(model.layout(), &model.default_run()) {
            note(&format!("the unit is for co-simulation only: the model has {lacks}"));
        }
        write(path, unit)
    }

    #[cfg(not(feature = "fmu"))]
    fn unit(&self, _: &Entry, _: &Path) -> Result<(), CommandError> {
        let text =
            "--fmu: this program is built without functional mock-up units: build it with --features fmu";
        Err(CommandError::Usage(text.to_owned()))
    }
}

fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), CommandError> {
    file::write(path, content).map(|()| file::tell_written(path))
}
