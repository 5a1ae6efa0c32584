//! The command line of anyone's models: `fn main() { liftoff::cli::run(liftoff::models![MyFrame]) }`.

mod animate;
mod asked;
mod completions;
mod csv_file;
mod diagnostics;
mod error;
mod examples;
mod explain;
mod interrupted;
mod json;
mod list;
mod modes;
mod plot;
mod precision;
mod print;
mod progress;
mod refusal;
mod report;
mod run;
mod sampling;
mod stability;
mod style;
mod sweep;
mod values;

pub use error::CommandError;
pub use interrupted::interrupted;
pub use print::print;

use crate::catalog::Models;
use crate::stability::Group;
use clap::{ColorChoice, CommandFactory, FromArgMatches, Parser, Subcommand};
use std::path::Path;
use std::process::exit;

/// Planar bar systems with one-sided supports
#[derive(Parser, Debug)]
#[command(about, after_help = EXIT_CODES)]
struct Cli<O: Own> {
    /// Whether to colour what is printed
    #[arg(long, value_name = "WHEN", global = true, default_value_t = ColorChoice::Auto)]
    color: ColorChoice,
    #[command(subcommand)]
    command: Option<Command<O>>,
}

const EXIT_CODES: &str = "Exit codes: 0 done; 1 failed on the way; 2 asked for what makes no sense; 130 interrupted by \
                          Ctrl-C: what was done by then is kept.";

#[derive(Subcommand, Debug)]
enum Command<O: Own> {
    #[command(flatten)]
    Own(O),
    /// List the models with their parameters, coordinates and supports
    List(list::List),
    /// Print the derived equations of a model, or of a file of Rust
    Explain(explain::Explain),
    /// Print the contact sets of a model, their degrees of freedom and how they follow one another
    Modes(modes::Modes),
    /// Simulate a model and print its events
    Run(Box<run::Run>),
    /// Draw a model or its motion as SVG
    Plot(Box<plot::Plot>),
    /// Simulate a model and write a page that plays its motion
    Animate(Box<animate::Animate>),
    /// Measure error against run time of models, method by method
    Precision(Box<precision::Precision>),
    /// Judge whether runs can be trusted: against double-double, other methods, other equations, other units
    Stability(stability::Stability),
    /// Run a model many times over ranges of its parameters and starts
    Sweep(Box<sweep::Sweep>),
    /// Write all that there is to know of models on a page each: drawing, equations, run, precision, stability
    Report(report::Report),
    /// Print what a shell needs to complete commands, options, models and methods
    Completions(completions::Completions),
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

    /// Groups of stability cases of one's own, judged beside the general ones.
    fn groups() -> &'static [Group] {
        &[]
    }

    /// The program's version, where it has one to tell.
    fn version() -> Option<&'static str> {
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
/// 2 asked for what makes no sense, 130 interrupted.
pub fn run(models: Models) -> ! {
    // The program ends with the command.
    execute::<Nothing>(Box::leak(Box::new(models)))
}

/// The same with commands of one's own.
pub fn run_with<O: Own>(models: &'static Models) -> ! {
    execute::<O>(models)
}

fn execute<O: Own>(models: &'static Models) -> ! {
    let asked =
        command::<O>(models).try_get_matches().and_then(|matches| Cli::<O>::from_arg_matches(&matches));
    let asked = asked.unwrap_or_else(|error| {
        let (line, code) = refusal::told(&error);
        line.inspect(|line| tell(line));
        exit(code)
    });
    colour(asked.color);
    let done = match asked.command.or_else(|| O::unasked().map(Command::Own)) {
        Some(command) => command.execute(models),
        None => print(&command::<O>(models).render_help().ansi().to_string()).map_err(Into::into),
    };
    match done {
        Ok(()) => exit(0),
        Err(error @ CommandError::Mistakes(_)) => {
            anstream::eprintln!("{error}");
            exit(error.code())
        }
        Err(error) => {
            tell(&error.to_string());
            exit(error.code())
        }
    }
}

/// All commands, with examples.
fn command<O: Own>(models: &Models) -> clap::Command {
    let command = Cli::<O>::command().name(program());
    let command = match O::version() {
        Some(version) => command.version(version),
        None => command,
    };
    examples::with_examples(command, models)
}

/// Prints what went wrong.
fn tell(error: &str) {
    anstream::eprintln!("{} {error}", style::styled(style::ERROR, "error:"));
}

fn colour(choice: ColorChoice) {
    match choice {
        // `NO_COLOR`, `CLICOLOR` and what is no terminal are heeded.
        ColorChoice::Auto => anstream::ColorChoice::Auto.write_global(),
        ColorChoice::Always => anstream::ColorChoice::Always.write_global(),
        ColorChoice::Never => anstream::ColorChoice::Never.write_global(),
    }
}

/// The name that the program was called by.
fn program() -> String {
    let path = std::env::args().next().unwrap_or_default();
    Path::new(&path).file_stem().map_or("liftoff".into(), |name| name.to_string_lossy().into_owned())
}

impl<O: Own> Command<O> {
    fn execute(self, models: &'static Models) -> Result<(), CommandError> {
        match self {
            Self::Own(own) => own.execute(models),
            Self::List(options) => options.execute(models),
            Self::Explain(options) => options.execute(models),
            Self::Modes(options) => options.execute(models),
            Self::Run(options) => options.execute(models),
            Self::Plot(options) => options.execute(models),
            Self::Animate(options) => options.execute(models),
            Self::Precision(options) => options.execute(models),
            Self::Report(options) => options.execute(models),
            Self::Stability(options) => options.execute(O::groups(), models),
            Self::Sweep(options) => options.execute(models),
            Self::Completions(options) => options.execute(command::<O>(models), models),
        }
    }
}
