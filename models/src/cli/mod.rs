//! The command line.

mod asked;
mod csv_file;
mod explain;
mod json;
mod list;
mod modes;
mod precision;
mod print;
mod run;
mod stability;
mod values;

use crate::catalog::Failure;
use crate::precision::FileError;
use crate::report::{ReportError, report};
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

/// Planar bar systems with one-sided supports.
#[derive(Parser, Debug)]
#[command(name = "liftoff", version, about)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand, Debug)]
enum Command {
    /// Reproduce the paper: print the table, write results.json and index.html (the default)
    Report(Report),
    /// Simulate a model and print its events
    Run(Box<run::Run>),
    /// Measure error against run time of models, method by method
    Precision(Box<precision::Precision>),
    /// List the models
    List,
    /// Print the derived equations of a model
    Explain(explain::Explain),
    /// Print the contact sets of a model, their degrees of freedom and how they follow one another
    Modes(modes::Modes),
    /// Run the stability suite: stiff, extreme and degenerate scenes with their verdicts
    Stability(stability::Stability),
}

#[derive(Args, Debug)]
struct Report {
    /// Relative tolerance of the integration
    #[arg(long, value_name = "X", default_value_t = Self::default().tol)]
    tol: f64,
    /// Where to write
    #[arg(long, value_name = "DIRECTORY", default_value_os_t = Self::default().out)]
    out: PathBuf,
    /// Another tool's rows, `scene,tolerance,error,end_error,microseconds`, named after the file
    #[arg(long, value_name = "FILE")]
    peers: Vec<PathBuf>,
}

impl Default for Report {
    fn default() -> Self {
        Self { tol: 1e-12, out: PathBuf::from("target/liftoff"), peers: Vec::new() }
    }
}

impl Report {
    fn execute(&self) -> Result<(), CommandError> {
        Ok(report(self.tol, &self.out, &self.peers, print::print)?)
    }
}

/// Why a command failed.
#[derive(thiserror::Error, Debug)]
pub enum CommandError {
    /// Something asked for that does not exist or makes no sense.
    #[error("{0}")]
    Usage(String),
    /// Something that went wrong on the way.
    #[error("{0}")]
    Failed(String),
}

impl From<Failure> for CommandError {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Input(text) => Self::Usage(text),
            Failure::Run { reason, .. } => Self::Failed(reason),
        }
    }
}

impl From<std::io::Error> for CommandError {
    fn from(error: std::io::Error) -> Self {
        Self::Failed(format!("cannot print: {error}"))
    }
}

impl From<FileError> for CommandError {
    fn from(error: FileError) -> Self {
        Self::Failed(error.to_string())
    }
}

impl From<ReportError> for CommandError {
    fn from(error: ReportError) -> Self {
        match error {
            ReportError::Run(failure) => failure.into(),
            other => Self::Failed(other.to_string()),
        }
    }
}

impl Cli {
    /// Does what was asked. Exit codes: 0 done, 1 failed on the way, 2 asked for what makes no sense.
    pub fn execute(self) -> ExitCode {
        let done = match self.command {
            None => Report::default().execute(),
            Some(Command::Report(options)) => options.execute(),
            Some(Command::Run(options)) => options.execute(),
            Some(Command::Precision(options)) => options.execute(),
            Some(Command::List) => list::execute(),
            Some(Command::Explain(options)) => options.execute(),
            Some(Command::Modes(options)) => options.execute(),
            Some(Command::Stability(options)) => options.execute(),
        };
        match done {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("error: {error}");
                ExitCode::from(if matches!(error, CommandError::Usage(_)) { 2 } else { 1 })
            }
        }
    }
}
