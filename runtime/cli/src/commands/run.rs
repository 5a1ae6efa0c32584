//! `liftoff run`.

use crate::CommandError;
use crate::errors::interrupted::{interrupted, is_interrupted};
use crate::options::run_args::RunArgs;
use crate::options::sampling::{Sampling, head};
use crate::options::states::States;
use crate::output::print::{print, tell};
use crate::output::progress::Progress;
use crate::output::style::{EVENT, LABEL, styled};
use crate::output::{csv_file, json};
use clap::Args;
use liftoff::Trajectory;
use liftoff_studio::registry::{Entry, MethodId, Models, MotionError, RunOptions, line_violation};
use liftoff_studio::run_spec::RunSpec;
use std::path::PathBuf;
use std::sync::Arc;

#[derive(Args, Debug)]
pub struct Run {
    /// Name of the model, as `list` has it
    model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// The method of integration
    #[arg(long, value_name = "NAME", default_value = "auto")]
    method: MethodId,
    #[command(flatten)]
    sampling: Sampling,
    /// Say whether the motion keeps its contacts and its energy and does not jump
    #[arg(long, conflicts_with_all = ["json", "csv"])]
    audit: bool,
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
        let spec = self.run_args.spec(model)?;
        self.warn(model, &spec);
        let options = RunOptions::by(self.method).cancel(Arc::clone(interrupted()));
        let progress = Progress::endless(format!("running {}", self.model));
        let mut states = (!self.needs_the_motion()).then(|| self.sampling.states());
        let outcome = match &mut states {
            None => model.run_by(options, &spec),
            Some(_) if self.sampling.is_of_events() => model.observe_by(options, &spec, &mut ()),
            Some(states) => model.observe_by(options, &spec, states),
        };
        drop(progress);
        match outcome {
            Ok(record) => {
                self.show(&spec, &record, states, None)?;
                self.sampling.check_reached(&record)
            }
            Err(MotionError::Run { reason, trajectory }) => {
                self.show(&spec, &trajectory, states, Some(&reason))?;
                Err(match is_interrupted() {
                    true => CommandError::Interrupted(reason),
                    false => CommandError::Failed(reason),
                })
            }
            Err(failure) => Err(failure.into()),
        }
    }

    /// Whether more is asked for than events and a table of states.
    fn needs_the_motion(&self) -> bool {
        let samples = self.json && !self.sampling.is_of_events();
        self.csv.is_some() || samples || !self.sampling.outputs().is_empty()
    }

    /// Of a start that is allowed and hardly meant.
    fn warn(&self, model: &Entry, spec: &RunSpec) {
        let nominal = RunSpec { start: Vec::new(), energy_of: Vec::new(), ..spec.clone() };
        if let (Ok(start), Ok(nominal)) = (model.configuration(spec), model.configuration(&nominal))
            && let Some(behind) = line_violation(&start, &nominal)
        {
            tell(&format!("{} {behind}", styled(LABEL, "note:")));
        }
    }

    fn show(
        &self,
        spec: &RunSpec,
        record: &Trajectory,
        states: Option<States>,
        error: Option<&str>,
    ) -> Result<(), CommandError> {
        if self.json {
            return Ok(print(&json::text(&self.model, spec, &self.sampling, record, error)?)?);
        }
        match states {
            _ if self.sampling.is_empty() => {
                print(&record.events().iter().map(describe).collect::<String>())?;
            }
            Some(states) => print(&self.sampling.table_of_states(record, states)?)?,
            None => print(&self.sampling.table(record)?)?,
        }
        if self.audit {
            print(&format!("{}\n", record.audit()))?;
        }
        match &self.csv {
            Some(path) => csv_file::write(record, &self.sampling, path),
            None => Ok(()),
        }
    }
}

fn describe(event: &liftoff::Event) -> String {
    let line = event.to_string();
    let what = head(&line);
    format!("{}{}\n", styled(EVENT, what), &line[what.len()..])
}
