//! `liftoff run --csv`, `--parquet`, `--arrow`, `--npz`.

use crate::CommandError;
use crate::commands::run::Ran;
use crate::options::clock::{Clock, Even};
use crate::options::samples::{Row, Samples};
use crate::options::sampling::Sampling;
use crate::output::file::unwritable;
use liftoff::{Observer, Output};
use liftoff_columnar::{Column, Format, Heading, Kind, Table, Value};
use liftoff_core::model::Layout;
use liftoff_studio::file::replace;
use liftoff_studio::registry::{Units, motion_columns};
use liftoff_studio::run_spec::RunSpec;
use std::io::{self, Write};
use std::path::Path;

/// A file that is to have the motion: comma-separated, or in columns.
pub struct MotionFile<'a> {
    pub path: &'a Path,
    pub format: Option<Format>,
}

/// What the file is of.
pub struct Subject<'a> {
    pub model: &'a str,
    pub layout: &'static Layout,
    pub spec: &'a RunSpec,
    pub sampling: &'a Sampling,
}

/// A table that is being written.
enum Rows<'a> {
    Separated(Box<csv::Writer<&'a mut (dyn Write + Send)>>),
    Columnar(Table<'a>),
}

impl MotionFile<'_> {
    /// Writes time, state, reactions, gaps, energies and the outputs asked for while `run` goes on: at the events, and at the times
    /// asked for or at equal intervals, as far as it came. The run with what kept the file from being written.
    pub fn write(
        &self,
        subject: &Subject<'_>,
        run: impl FnOnce(&mut dyn Observer) -> Result<Ran, CommandError>,
    ) -> Result<(Ran, Result<(), CommandError>), CommandError> {
        let sampling = subject.sampling;
        let columns = subject.columns();
        let samples = subject.samples(&columns)?;
        let heading = subject.heading(&columns)?;
        let mut ran = None;
        let written = replace(self.path, |out| {
            let mut table = match self.format {
                Some(format) => Rows::Columnar(Table::begin(format, &heading, out)?),
                None => Rows::separated(&subject.heads(&columns), out)?,
            };
            let mut failure = Ok(());
            let mut write = |row: &Row| {
                if failure.is_ok() {
                    failure = table.add(&row.values);
                }
            };
            let watch = |mut samples: Samples<'_>| {
                let done = ran.insert(run(&mut samples));
                done.as_ref().map_or(Vec::new(), |ran| samples.finish(&ran.record))
            };
            let rows = match sampling.is_of_events() {
                true => watch(samples),
                false => watch(samples.into_sink(&mut write)),
            };
            rows.iter().for_each(&mut write);
            failure?;
            match ran.as_ref().is_some_and(Result::is_ok) {
                true => table.finish(),
                false => Err(io::Error::other("the run did not begin")),
            }
        });
        match (ran, written) {
            (Some(Ok(ran)), written) => Ok((ran, written.map_err(|error| unwritable(self.path, &error)))),
            (Some(Err(error)), _) => Err(error),
            (None, Err(error)) => Err(unwritable(self.path, &error)),
            (None, Ok(())) => Err(unwritable(self.path, &"nothing was run")),
        }
    }
}

impl<'a> Rows<'a> {
    fn separated(heads: &[String], out: &'a mut (dyn Write + Send)) -> io::Result<Self> {
        let mut table = csv::Writer::from_writer(out);
        table.write_record(heads)?;
        Ok(Self::Separated(Box::new(table)))
    }

    fn add(&mut self, values: &[f64]) -> io::Result<()> {
        match self {
            Self::Separated(table) => Ok(table.write_record(values.iter().map(f64::to_string))?),
            Self::Columnar(table) => table.row(values.iter().copied().map(Value::Number)),
        }
    }

    fn finish(self) -> io::Result<()> {
        match self {
            Self::Separated(mut table) => table.flush(),
            Self::Columnar(table) => table.finish(),
        }
    }
}

impl Subject<'_> {
    /// The outputs that stand in the columns, each once.
    fn columns(&self) -> Vec<String> {
        let mut columns = motion_columns(self.layout);
        for output in self.sampling.outputs() {
            if !columns.contains(output) {
                columns.push(output.clone());
            }
        }
        columns
    }

    /// What looks at the motion that the file is to have.
    fn samples(&self, columns: &[String]) -> Result<Samples<'static>, CommandError> {
        let outputs: Result<Vec<_>, _> =
            columns.iter().map(|column| Output::parse(self.layout, column)).collect();
        let sampling = self.sampling;
        let clock = if sampling.is_of_events() { Clock::Even(Even::default()) } else { sampling.clock() };
        Ok(Samples::new(outputs?, clock))
    }

    /// What stands over the columns of comma-separated values.
    fn heads(&self, columns: &[String]) -> Vec<String> {
        let units = Units::from_layout(self.layout);
        columns.iter().map(|name| units.head(name)).collect()
    }

    /// Columns with units; what is said of the run.
    fn heading(&self, columns: &[String]) -> Result<Heading, CommandError> {
        let units = Units::from_layout(self.layout);
        let column = |name: &String| Column::new(name, Kind::Number, units.symbol(name).as_deref());
        let heading = Heading::new(columns.iter().map(column).collect());
        let heading = heading.map_err(|twice| CommandError::Usage(twice.to_string()))?;
        let spec =
            serde_json::to_string(self.spec).map_err(|error| CommandError::Failed(error.to_string()))?;
        Ok(heading
            .entry("version", env!("CARGO_PKG_VERSION"))
            .entry("model", self.model)
            .hashed("declaration", self.layout.declaration)
            .hashed("run", spec))
    }
}
