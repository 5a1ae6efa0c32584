//! `liftoff animate`.

use super::CommandError;
use super::asked::Asked;
use super::interrupted::{interrupted, is_interrupted};
use super::print::print;
use super::progress::Progress;
use crate::animation::{self, About};
use crate::catalog::{Failure, Integrator, Model, Models, Record, Way};
use crate::scene::Setup;
use clap::Args;
use std::path::{Path, PathBuf};

#[derive(Args, Debug)]
pub struct Animate {
    /// Name of the model, as `list` has it
    model: String,
    #[command(flatten)]
    asked: Asked,
    /// The method of integration
    #[arg(long, value_name = "NAME", default_value = "auto")]
    method: Integrator,
    /// An expression to draw over time, beside coordinates, reactions and energies
    #[arg(long, value_name = "EXPR")]
    output: Vec<String>,
    /// The page to write; by default MODEL.html in the current directory
    #[arg(long, value_name = "FILE.html")]
    out: Option<PathBuf>,
    /// Open the page in the browser
    #[arg(long)]
    open: bool,
}

impl Animate {
    /// Runs the model and writes the page of its motion; that of a run that stopped short goes as far as it came, and
    /// says why.
    pub fn execute(self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        self.output.iter().try_for_each(|output| model.check(output))?;
        let setup = self.asked.setup(model.setup());
        let way = Way::by(self.method).cancel(interrupted());
        let progress = Progress::endless(format!("running {}", self.model));
        let outcome = model.run_by(way, &setup);
        drop(progress);
        match outcome {
            Ok(record) => self.write(model, &setup, &*record, None),
            Err(Failure::Run { reason, record }) => {
                self.write(model, &setup, &*record, Some(&reason))?;
                Err(match is_interrupted() {
                    true => CommandError::Interrupted(reason),
                    false => CommandError::Failed(reason),
                })
            }
            Err(failure) => Err(failure.into()),
        }
    }

    fn write(
        &self,
        model: &dyn Model,
        setup: &Setup,
        record: &dyn Record,
        stopped: Option<&str>,
    ) -> Result<(), CommandError> {
        let about = About {
            title: model.name(),
            summary: model.summary(),
            parameters: &setup.parameters,
            outputs: &self.output,
            stopped,
        };
        let page = animation::page(record, &about)?;
        let path = self.out.clone().unwrap_or_else(|| format!("{}.html", model.name()).into());
        std::fs::write(&path, page).map_err(|error| refused("write", &path, &error))?;
        print(&format!("{}\n", path.display()))?;
        match self.open {
            true => open::that_detached(&path).map_err(|error| refused("open", &path, &error)),
            false => Ok(()),
        }
    }
}

fn refused(what: &str, path: &Path, error: &std::io::Error) -> CommandError {
    CommandError::Failed(format!("cannot {what} {}: {error}", path.display()))
}
