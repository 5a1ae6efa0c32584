//! What our own command does beside what every program with models does.

use crate::paper::{ReportError, report};
use crate::stability::GROUPS;
use clap::{Args, Subcommand};
use liftoff_cli::{CommandError, ExtraCommand, check_folder, print};
use liftoff_studio::registry::Models;
use liftoff_verification::cases::Group;
use std::path::PathBuf;

/// Commands of our own.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Reproduce the paper: print the table, write results.json and index.html (the default)
    Paper(Paper),
}

/// The paper, reproduced.
#[derive(Args, Debug)]
pub struct Paper {
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

impl Default for Paper {
    fn default() -> Self {
        Self { tol: 1e-12, out: PathBuf::from("target/liftoff"), peers: Vec::new() }
    }
}

impl ExtraCommand for Command {
    fn execute(self, _: &Models) -> Result<(), CommandError> {
        match self {
            Self::Paper(paper) => {
                check_folder(&paper.out)?;
                Ok(report(paper.tol, &paper.out, &paper.peers, print)?)
            }
        }
    }

    fn groups() -> &'static [Group] {
        &GROUPS
    }

    fn version() -> Option<&'static str> {
        Some(env!("CARGO_PKG_VERSION"))
    }

    fn default_command() -> Option<Self> {
        Some(Self::Paper(Paper::default()))
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
