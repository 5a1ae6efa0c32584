//! `liftoff animate`.

use crate::CommandError;
use crate::errors::interrupted::{interrupted, is_interrupted};
use crate::options::run_args::RunArgs;
use crate::output::file::{print_beside, probe, write};
use crate::output::progress::Progress;
use clap::Args;
use liftoff::Trajectory;
use liftoff_studio::animation::{self, About};
use liftoff_studio::registry::{Entry, MethodId, Models, MotionError, RunOptions};
use liftoff_studio::run_spec::RunSpec;
use std::path::PathBuf;
use std::sync::Arc;

#[derive(Args, Debug)]
pub struct Animate {
    /// Name of the model, as `list` has it
    model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// The method of integration
    #[arg(long, value_name = "NAME", default_value = "auto")]
    method: MethodId,
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
        let path = self.path(model);
        probe(&path)?;
        let spec = self.run_args.spec(model)?;
        let options = RunOptions::by(self.method).cancel(Arc::clone(interrupted()));
        let progress = Progress::endless(format!("running {}", self.model));
        let outcome = model.run_by(options, &spec);
        drop(progress);
        match outcome {
            Ok(record) => self.write(model, &spec, &record, None),
            Err(MotionError::Run { reason, trajectory }) => {
                self.write(model, &spec, &trajectory, Some(&reason))?;
                Err(match is_interrupted() {
                    true => CommandError::Interrupted(reason),
                    false => CommandError::Failed(reason),
                })
            }
            Err(failure) => Err(failure.into()),
        }
    }

    fn path(&self, model: &Entry) -> PathBuf {
        self.out.clone().unwrap_or_else(|| format!("{}.html", model.name()).into())
    }

    fn write(
        &self,
        model: &Entry,
        spec: &RunSpec,
        record: &Trajectory,
        stopped: Option<&str>,
    ) -> Result<(), CommandError> {
        let about = About {
            title: model.name(),
            summary: model.summary(),
            parameters: &spec.parameters,
            outputs: &self.output,
            stopped,
        };
        let page = animation::page(record, &about)?;
        let path = self.path(model);
        write(&path, page)?;
        print_beside(Some(&path), &format!("{}\n", path.display()))?;
        match self.open {
            true => open::that_detached(&path)
                .map_err(|error| CommandError::Failed(format!("cannot open {}: {error}", path.display()))),
            false => Ok(()),
        }
    }
}
