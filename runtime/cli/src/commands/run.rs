//! `liftoff run`.

use crate::CommandError;
use crate::errors::interrupted::{interrupted, is_interrupted};
use crate::options::budget::BudgetArgs;
use crate::options::columnar_files::ColumnarFiles;
use crate::options::run_args::RunArgs;
use crate::options::samples::{Observers, Samples};
use crate::options::sampling::{Sampling, head};
use crate::output::file::{Form, check_form, is_output, print_beside, tell_written};
use crate::output::json;
use crate::output::motion_file::{MotionFile, Subject};
use crate::output::notes::note;
use crate::output::print::print;
use crate::output::progress::Progress;
use crate::output::style::{EVENT, styled};
use clap::Args;
use liftoff::__private::expression::significant;
use liftoff::{Observer, Output, Trajectory};
use liftoff_core::model::Layout;
use liftoff_studio::registry::{Entry, MethodId, Models, RunOptions, as_far, run_notes, start_notes};
use liftoff_studio::run_spec::RunSpec;
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[derive(Args, Debug)]
pub struct Run {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    #[command(flatten)]
    run_args: RunArgs,
    /// The method of integration
    #[arg(long, value_name = "NAME", default_value = "auto")]
    method: MethodId,
    #[command(flatten)]
    sampling: Sampling,
    /// Check that the motion satisfies contacts and energy balance and has no jumps
    #[arg(long, conflicts_with_all = ["json", "csv", "parquet", "arrow", "npz"])]
    audit: bool,
    /// Print JSON
    #[arg(long, conflicts_with_all = ["csv", "parquet", "arrow", "npz"])]
    json: bool,
    /// Write the motion to a file, with units in the head, `phi [rad]`; `-` is the standard output, and the events go to the
    /// standard error output
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    #[command(flatten)]
    columnar: ColumnarFiles,
    #[command(flatten)]
    budget: BudgetArgs,
}

/// A run as far as it came.
pub struct Ran {
    pub record: Trajectory,
    /// Why it came no further.
    pub error: Option<String>,
}

impl Run {
    /// Runs the model; a run that stopped short or was interrupted is printed as far as it came.
    pub fn execute(self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let spec = self.run_args.spec(model)?;
        self.sampling.check(model, &spec)?;
        start_notes(model, &spec).iter().for_each(|text| note(text));
        let mut samples = self.samples(model.layout())?;
        let file = self.file()?;
        let (ran, written) = match &file {
            Some(file) => {
                let subject = Subject {
                    model: model.name(),
                    layout: model.layout(),
                    spec: &spec,
                    sampling: &self.sampling,
                };
                file.write(&subject, |file| self.run(model, &spec, (samples.as_mut(), Some(file))))?
            }
            None => (self.run(model, &spec, (samples.as_mut(), None))?, Ok(())),
        };
        self.show(&spec, &ran, samples)?;
        self.completed(&ran.record).iter().for_each(|text| note(text));
        run_notes(&ran.record).iter().for_each(|text| note(text));
        self.run_args.note_end(&ran.record);
        written?;
        file.iter().for_each(|file| tell_written(file.path));
        match ran.error {
            Some(reason) if is_interrupted() => Err(CommandError::Interrupted(reason)),
            Some(reason) => Err(CommandError::Failed(reason)),
            None => self.sampling.check_reached(&ran.record),
        }
    }

    /// The file that is to have the motion, if one is.
    fn file(&self) -> Result<Option<MotionFile<'_>>, CommandError> {
        self.csv.iter().try_for_each(|path| check_form(path, &[Form::CSV]))?;
        self.columnar.check()?;
        let csv = self.csv.iter().map(|path| ("--csv", None, path.as_path()));
        let columnar = self.columnar.each().map(|(option, format, path)| (option, Some(format), path));
        let files: Vec<_> = csv.chain(columnar).collect();
        match files[..] {
            [(one, ..), (other, ..), ..] => {
                Err(CommandError::Usage(format!("{one} and {other}: a run writes its motion to one file")))
            }
            _ => Ok(files.first().map(|&(_, format, path)| MotionFile { path, format })),
        }
    }

    /// The path of the file that is to have the motion.
    fn path(&self) -> Option<&Path> {
        self.csv.as_deref().or_else(|| self.columnar.each().next().map(|(.., path)| path))
    }

    /// What looks at the motion for what is printed, if more is than the events.
    fn samples(&self, layout: &'static Layout) -> Result<Option<Samples<'static>>, CommandError> {
        let columns = match self.json {
            _ if self.sampling.is_empty() => return Ok(None),
            true => json::columns(layout, &self.sampling),
            false => self.sampling.columns(layout),
        };
        let outputs: Result<Vec<_>, _> = columns.iter().map(|text| Output::parse(layout, text)).collect();
        Ok(Some(Samples::new(outputs?, self.sampling.printed(self.path().is_some()))))
    }

    fn run(
        &self,
        model: &Entry,
        spec: &RunSpec,
        (samples, file): (Option<&mut Samples>, Option<&mut dyn Observer>),
    ) -> Result<Ran, CommandError> {
        let options = RunOptions::by(self.method).cancel(Arc::clone(interrupted()));
        let options = options.budget(self.budget.budget());
        // What is written to a terminal would mix with it.
        let is_shown = self.path().is_none_or(|path| !path.starts_with("/dev") && !is_output(path));
        let _progress = is_shown.then(|| Progress::endless(format!("running {}", self.model)));
        let mut observers = Observers { samples: Vec::new(), keeps: self.audit };
        if let Some(samples) = samples {
            observers.samples.push(samples);
        }
        if let Some(file) = file {
            observers.samples.push(file);
        }
        let (record, error) = as_far(model.observe_by(options, spec, &mut observers))?;
        let ran = Ran { record, error };
        self.sampling.check_rows(&ran.record)?;
        Ok(ran)
    }

    /// What a start that is given in part has been completed to.
    fn completed(&self, record: &Trajectory) -> Option<String> {
        let start = record.events().first()?;
        let layout = record.layout();
        let rates = layout.names_of_positions().map(|name| format!("{name}'"));
        let rates = rates.filter(|name| start[name.as_str()] != 0.0);
        let names = layout.names_of_positions().map(str::to_owned).chain(rates);
        let open: Vec<String> = names
            .filter(|name| !self.run_args.is_given(name))
            .map(|name| format!("{name} = {}", significant(start[name.as_str()], 4)))
            .collect();
        (self.run_args.has_start() && !open.is_empty()).then(|| {
            format!(
                "the start is completed by {}, near the figure and according to the contacts",
                open.join(", ")
            )
        })
    }

    fn show(&self, spec: &RunSpec, ran: &Ran, samples: Option<Samples>) -> Result<(), CommandError> {
        let rows = samples.map_or_else(Vec::new, |samples| samples.finish(&ran.record));
        let record = &ran.record;
        if self.json {
            let motion = (record, &rows[..]);
            return Ok(print(&json::text(&self.model, spec, &self.sampling, motion, ran.error.as_deref())?)?);
        }
        let mut write = |text: &str| print_beside(self.path(), text);
        match self.sampling.is_empty() {
            true => write(&record.events().iter().map(describe).collect::<String>())?,
            false => self.sampling.table(record, rows, &mut write)?,
        }
        if self.audit {
            print(&format!("{}\n", record.audit()))?;
        }
        Ok(())
    }
}

fn describe(event: &liftoff::Event) -> String {
    let line = event.to_string();
    let what = head(&line);
    format!("{}{}\n", styled(EVENT, what), &line[what.len()..])
}
