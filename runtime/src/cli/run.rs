//! `liftoff run`.

use super::CommandError;
use super::asked::Asked;
use super::print::print;
use super::{csv_file, json};
use crate::catalog::{Failure, Models, Record};
use crate::scene::Setup;
use clap::Args;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct Run {
    /// Name of the model, see `liftoff list`
    model: String,
    #[command(flatten)]
    asked: Asked,
    /// Print JSON
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Write the motion to a file
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

impl Run {
    /// Runs the model; a run that stopped short is printed as far as it came.
    pub fn execute(self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let setup = self.asked.setup(model.setup());
        match model.run(&setup) {
            Ok(record) => self.show(&setup, &*record, None),
            Err(Failure::Run { reason, record }) => {
                self.show(&setup, &*record, Some(&reason))?;
                Err(CommandError::Failed(reason))
            }
            Err(failure) => Err(failure.into()),
        }
    }

    fn show(&self, setup: &Setup, record: &dyn Record, error: Option<&str>) -> Result<(), CommandError> {
        if self.json {
            return Ok(print(&json::text(&self.model, setup, record, error)?)?);
        }
        let events: String = record.events().iter().map(|event| format!("{event}\n")).collect();
        print(&events)?;
        match &self.csv {
            Some(path) => csv_file::write(record, path),
            None => Ok(()),
        }
    }
}
