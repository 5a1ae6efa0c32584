//! The command line of anyone's models: `fn main() { liftoff_cli::run(liftoff_cli::models![MyFrame]) }`.
//!
//! [`run`] has the commands that all programs have, [`run_with`] further ones ([`ExtraCommand`]) beside them. A model that
//! implements [`DefaultRun`] needs no options to be run. What the commands show is made by [`studio`].
//!
//! - [`book`]: how models are declared, run and read, from an empty directory on.
//! - `commands`: each in a module of its own name; `options`: what several of them ask for, and help by example.
//! - `output`: what is written, and how; `errors`: error messages.

pub mod book;
mod commands;
mod errors;
mod options;
mod output;

pub use errors::{CommandError, interrupted};
pub use liftoff_studio as studio;
pub use liftoff_studio::{DefaultRun, RunSpec, models};
pub use output::{file::check_folder, print};

use clap::{ColorChoice, CommandFactory, FromArgMatches, Parser, Subcommand};
use commands::{
    animate, boundary, completions, conditions, equilibrium, explain, export, fit, linearise, list, merge,
    modes, new, optimise, orbit, plot, precision, report, sensitivity, stability, sweep, watch, words,
};
use errors::parse_error;
use liftoff_studio::checks::Group;
use liftoff_studio::registry::Models;
use options::{examples, files};
use output::print::tell;
use output::style;
use std::path::Path;
use std::process::exit;

/// Planar bar systems with one-sided supports
#[derive(Parser, Debug)]
#[command(about, after_help = EXIT_CODES)]
struct Cli<O: ExtraCommand> {
    /// Whether to colour the output
    #[arg(long, value_name = "WHEN", global = true, default_value_t = ColorChoice::Auto)]
    color: ColorChoice,
    /// The model to take from a FILE.rs with several
    #[arg(long, id = "of_file", value_name = "NAME", global = true, alias = "struct")]
    model: Option<String>,
    #[command(subcommand)]
    command: Option<Command<O>>,
}

const EXIT_CODES: &str = "Exit codes: 0 done; 1 failed on the way; 2 invalid request; 130 interrupted by \
                          Ctrl-C: what was done by then is kept.";

#[derive(Subcommand, Debug)]
enum Command<O: ExtraCommand> {
    #[command(flatten)]
    Extra(O),
    /// List the models with their parameters, coordinates and supports
    List(list::List),
    /// Print the derived equations of a model, or of a file of Rust
    Explain(explain::Explain),
    /// Print when each reaction of a model vanishes, as a formula, and what stays constant
    Conditions(conditions::Conditions),
    /// Write the equations of a model as a source for another program: SymPy
    Export(export::Export),
    /// Print the contact sets of a model, their degrees of freedom and how they follow one another
    Modes(modes::Modes),
    /// Find the equilibria of a model, with contact reactions and vibrations
    Equilibrium(equilibrium::Equilibrium),
    /// Print frequencies, damping and mode shapes about a position at rest
    Linearise(linearise::Linearise),
    /// Simulate a model and print how its events and its end depend on parameters and the start
    Sensitivity(Box<sensitivity::Sensitivity>),
    /// Find parameters and starts from measured series and event times by least squares, with their errors
    Fit(Box<fit::Fit>),
    /// Find parameters and starts with which an output is least or greatest
    Optimise(Box<optimise::Optimise>),
    /// Find a periodic orbit with its multipliers, and follow it in a parameter
    Orbit(Box<orbit::Orbit>),
    /// Simulate a model and print its events
    Run(Box<commands::run::Run>),
    /// Draw a model or its motion as SVG
    Plot(Box<plot::Plot>),
    /// Simulate a model and write a page that plays its motion
    Animate(Box<animate::Animate>),
    /// Show the motion of a file's model on a page that is updated at every save
    Watch(Box<watch::Watch>),
    /// Measure error against run time of models, method by method
    Precision(Box<precision::Precision>),
    /// Check runs numerically: against double-double, other methods, other equations, other units
    Stability(stability::Stability),
    /// Run a model many times over ranges of its parameters and starts
    Sweep(Box<sweep::Sweep>),
    /// Follow curves in a plane of two parameters or starts across which an observed result changes
    Boundary(Box<boundary::Boundary>),
    /// Merge the parts of a sweep by `sweep --shard` into one table
    Merge(merge::Merge),
    /// Write a page for each model: drawing, equations, run, precision, stability
    Report(report::Report),
    /// Print the words of the language, or one of them with its equation and an example
    Words(words::Words),
    /// Write a project with a model of one's own and these commands
    New(new::New),
    /// Print a completion script for a shell: commands, options, models and methods
    Completions(completions::Completions),
}

/// Commands that a program adds to the standard ones.
pub trait ExtraCommand: Subcommand + std::fmt::Debug {
    /// Executes the command.
    ///
    /// # Errors
    /// The error; its text is printed.
    fn execute(self, models: &Models) -> Result<(), CommandError>;

    /// The command to execute if none is given; by default the help is printed.
    fn default_command() -> Option<Self> {
        None
    }

    /// Further groups of cases for `stability`, judged beside the general ones.
    fn groups() -> &'static [Group] {
        &[]
    }

    /// Version of the program for `--version`, if any.
    fn version() -> Option<&'static str> {
        None
    }
}

/// No further commands.
#[derive(Subcommand, Debug)]
enum NoCommand {}

impl ExtraCommand for NoCommand {
    fn execute(self, _: &Models) -> Result<(), CommandError> {
        match self {}
    }
}

/// Reads the arguments of the process and does with `models` what they ask for. Exit codes: 0 done, 1 failed on the way,
/// 2 invalid request, 130 interrupted.
pub fn run(models: Models) -> ! {
    // The program ends with the command.
    execute::<NoCommand>(Box::leak(Box::new(models)))
}

/// The same with further commands.
pub fn run_with<O: ExtraCommand>(models: &'static Models) -> ! {
    execute::<O>(models)
}

fn execute<O: ExtraCommand>(models: &'static Models) -> ! {
    let arguments =
        command::<O>(models).try_get_matches().and_then(|matches| Cli::<O>::from_arg_matches(&matches));
    let arguments = arguments.unwrap_or_else(|error| {
        let (line, code) = parse_error::report(&error);
        // Each process of a launcher has the same arguments.
        line.filter(|_| !liftoff_processes::follows()).inspect(|line| print_error(line));
        exit(code)
    });
    colour(arguments.color);
    let done = match arguments.command.or_else(|| O::default_command().map(Command::Extra)) {
        Some(command) => command.execute(models, arguments.model),
        None => print(&command::<O>(models).render_help().ansi().to_string()).map_err(Into::into),
    };
    match done {
        Ok(()) => exit(0),
        Err(error @ CommandError::Mistakes(_)) => {
            tell(&error.to_string());
            exit(error.code())
        }
        Err(error) => {
            print_error(&error.to_string());
            exit(error.code())
        }
    }
}

/// All commands, with examples.
fn command<O: ExtraCommand>(models: &Models) -> clap::Command {
    let command = Cli::<O>::command().name(program());
    let command = match O::version() {
        Some(version) => command.version(version),
        None => command,
    };
    examples::with_examples(command, models)
}

/// Prints what went wrong.
fn print_error(error: &str) {
    tell(&format!("{} {error}", style::styled(style::ERROR, "error:")));
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

impl<O: ExtraCommand> Command<O> {
    /// The words that name models.
    fn names(&mut self) -> Vec<&mut String> {
        match self {
            Self::Extra(_)
            | Self::Explain(_)
            | Self::Watch(_)
            | Self::Merge(_)
            | Self::New(_)
            | Self::Words(_)
            | Self::Completions(_) => Vec::new(),
            Self::List(options) => options.models.iter_mut().collect(),
            Self::Precision(options) => options.models.iter_mut().collect(),
            Self::Report(options) => options.models.iter_mut().collect(),
            // Groups have names too.
            Self::Stability(options) => {
                options.names.iter_mut().filter(|name| name.ends_with(".rs") || name.contains('/')).collect()
            }
            Self::Conditions(options) => vec![&mut options.model],
            Self::Export(options) => vec![&mut options.model],
            Self::Modes(options) => vec![&mut options.model],
            Self::Equilibrium(options) => vec![&mut options.model],
            Self::Linearise(options) => vec![&mut options.model],
            Self::Sensitivity(options) => vec![&mut options.model],
            Self::Fit(options) => vec![&mut options.model],
            Self::Optimise(options) => vec![&mut options.model],
            Self::Orbit(options) => vec![&mut options.model],
            Self::Run(options) => vec![&mut options.model],
            Self::Plot(options) => vec![&mut options.model],
            Self::Animate(options) => vec![&mut options.model],
            Self::Boundary(options) => vec![&mut options.model],
            Self::Sweep(options) => options.model().into_iter().collect(),
        }
    }

    /// Does it with the models there are, and those of the files that it names.
    fn execute(mut self, models: &'static Models, chosen: Option<String>) -> Result<(), CommandError> {
        let models = match self {
            // These choose by themselves: `watch` anew on every save, `explain` of several without a choice takes all.
            Self::Watch(_) | Self::Explain(_) | Self::New(_) => models,
            _ => files::resolved(self.names(), chosen.as_deref(), models)?,
        };
        match self {
            Self::Watch(options) => options.execute(chosen),
            Self::New(options) => options.execute(models, chosen.as_deref()),
            Self::Words(options) => options.execute(),
            Self::Merge(options) => options.execute(),
            Self::Extra(extra) => extra.execute(models),
            Self::List(options) => options.execute(models),
            Self::Explain(options) => options.execute(models, chosen.as_deref()),
            Self::Conditions(options) => options.execute(models),
            Self::Export(options) => options.execute(models),
            Self::Modes(options) => options.execute(models),
            Self::Equilibrium(options) => options.execute(models),
            Self::Linearise(options) => options.execute(models),
            Self::Sensitivity(options) => options.execute(models),
            Self::Fit(options) => options.execute(models),
            Self::Optimise(options) => options.execute(models),
            Self::Orbit(options) => options.execute(models),
            Self::Run(options) => options.execute(models),
            Self::Plot(options) => options.execute(models),
            Self::Animate(options) => options.execute(models),
            Self::Precision(options) => options.execute(models),
            Self::Report(options) => options.execute(models),
            Self::Stability(options) => options.execute(O::groups(), models),
            Self::Sweep(options) => options.execute(models),
            Self::Boundary(options) => options.execute(models),
            Self::Completions(options) => options.execute(command::<O>(models), models),
        }
    }
}

#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
