//! `liftoff run`.

use super::CommandError;
use super::asked::Asked;
use super::interrupted::{interrupted, is_interrupted};
use super::print::print;
use super::progress::Progress;
use super::sampling::{Sampling, head};
use super::style::{EVENT, LABEL, styled};
use super::{csv_file, json};
use crate::catalog::{Failure, Integrator, Model, Models, Record, Way, behind};
use crate::scene::Setup;
use clap::Args;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct Run {
    /// Name of the model, as `list` has it
    model: String,
    #[command(flatten)]
    asked: Asked,
    /// The method of integration
    #[arg(long, value_name = "NAME", default_value = "auto")]
    method: Integrator,
    #[command(flatten)]
    sampling: Sampling,
    /// Print JSON
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Write the motion to a file
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

impl Run {
    /// Runs the model; a run that stopped short or was interrupted is printed as far as it came.
    pub fn execute(self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        self.sampling.check(model)?;
        let setup = self.asked.setup(model.setup());
        self.warn(model, &setup);
        let way = Way::by(self.method).cancel(interrupted());
        let progress = Progress::endless(format!("running {}", self.model));
        let outcome = model.run_by(way, &setup);
        drop(progress);
        match outcome {
            Ok(record) => self.show(&setup, &*record, None),
            Err(Failure::Run { reason, record }) => {
                self.show(&setup, &*record, Some(&reason))?;
                Err(match is_interrupted() {
                    true => CommandError::Interrupted(reason),
                    false => CommandError::Failed(reason),
                })
            }
            Err(failure) => Err(failure.into()),
        }
    }

    /// Of a start that is allowed and hardly meant.
    fn warn(&self, model: &dyn Model, setup: &Setup) {
        let nominal = Setup { start: Vec::new(), energy_of: Vec::new(), ..setup.clone() };
        if let (Ok(start), Ok(nominal)) = (model.still(setup), model.still(&nominal))
            && let Some(behind) = behind(&start, &nominal)
        {
            anstream::eprintln!("{} {behind}", styled(LABEL, "note:"));
        }
    }

    fn show(&self, setup: &Setup, record: &dyn Record, error: Option<&str>) -> Result<(), CommandError> {
        if self.json {
            return Ok(print(&json::text(&self.model, setup, &self.sampling, record, error)?)?);
        }
        match self.sampling.is_empty() {
            true => print(&record.events().iter().map(told).collect::<String>())?,
            false => print(&self.sampling.table(record)?)?,
        }
        match &self.csv {
            Some(path) => csv_file::write(record, &self.sampling, path),
            None => Ok(()),
        }
    }
}

fn told(event: &crate::Event) -> String {
    let line = event.to_string();
    let what = head(&line);
    format!("{}{}\n", styled(EVENT, what), &line[what.len()..])
}
