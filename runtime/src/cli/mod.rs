//! The command line of anyone's models: `fn main() { liftoff::cli::run(liftoff::models![MyFrame]) }`.

mod animate;
mod asked;
mod csv_file;
mod error;
mod explain;
mod json;
mod list;
mod modes;
mod precision;
mod print;
mod run;
mod values;

pub use error::CommandError;
pub use print::print;

use crate::catalog::Models;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::path::Path;
use std::process::exit;

/// Planar bar systems with one-sided supports
#[derive(Parser, Debug)]
#[command(version, about)]
struct Cli<O: Own> {
    #[command(subcommand)]
    command: Option<Command<O>>,
}

#[derive(Subcommand, Debug)]
enum Command<O: Own> {
    #[command(flatten)]
    Own(O),
    /// List the models
    List,
    /// Print the derived equations of a model
    Explain(explain::Explain),
    /// Print the contact sets of a model, their degrees of freedom and how they follow one another
    Modes(modes::Modes),
    /// Simulate a model and print its events
    Run(Box<run::Run>),
    /// Simulate a model and write a page that plays its motion
    Animate(Box<animate::Animate>),
    /// Measure error against run time of models, method by method
    Precision(Box<precision::Precision>),
}

/// Commands of a program's own, beside those that all have.
pub trait Own: Subcommand + std::fmt::Debug {
    /// Does what was asked.
    ///
    /// # Errors
    /// What went wrong: its text is printed.
    fn execute(self, models: &Models) -> Result<(), CommandError>;

    /// What to do where no command is given; by default the help is printed.
    fn unasked() -> Option<Self> {
        None
    }
}

/// No commands of one's own.
#[derive(Subcommand, Debug)]
enum Nothing {}

impl Own for Nothing {
    fn execute(self, _: &Models) -> Result<(), CommandError> {
        match self {}
    }
}

/// Reads the arguments of the process and does with `models` what they ask for. Exit codes: 0 done, 1 failed on the way,
/// 2 asked for what makes no sense.
pub fn run(models: Models) -> ! {
    execute::<Nothing>(&models)
}

/// The same with commands of one's own.
pub fn run_with<O: Own>(models: &Models) -> ! {
    execute::<O>(models)
}

fn execute<O: Own>(models: &Models) -> ! {
    let matches = Cli::<O>::command().name(program()).get_matches();
    let asked = Cli::<O>::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    let done = match asked.command.or_else(|| O::unasked().map(Command::Own)) {
        Some(command) => command.execute(models),
        None => print(&Cli::<O>::command().name(program()).render_help().to_string()).map_err(Into::into),
    };
    match done {
        Ok(()) => exit(0),
        Err(error) => {
            eprintln!("error: {error}");
            exit(if matches!(error, CommandError::Usage(_)) { 2 } else { 1 })
        }
    }
}

/// The name that the program was called by.
fn program() -> String {
    let path = std::env::args().next().unwrap_or_default();
    Path::new(&path).file_stem().map_or("liftoff".into(), |name| name.to_string_lossy().into_owned())
}

impl<O: Own> Command<O> {
    fn execute(self, models: &Models) -> Result<(), CommandError> {
        match self {
            Self::Own(own) => own.execute(models),
            Self::List => list::execute(models),
            Self::Explain(options) => options.execute(models),
            Self::Modes(options) => options.execute(models),
            Self::Run(options) => options.execute(models),
            Self::Animate(options) => options.execute(models),
            Self::Precision(options) => options.execute(models),
        }
    }
}
