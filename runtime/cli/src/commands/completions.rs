//! `liftoff completions`: what a shell needs to complete commands, options, and the names of models and methods.

use crate::CommandError;
use crate::output::print::print;
use clap::builder::PossibleValuesParser;
use clap::{Args, Command};
use clap_complete::Shell;
use liftoff_studio::registry::{MethodId, Models};

/// Arguments that name models, and those that name methods.
const OF_MODELS: [&str; 2] = ["model", "models"];
const OF_METHODS: [&str; 2] = ["method", "methods"];

#[derive(Args, Debug)]
pub struct Completions {
    /// The shell to complete in
    shell: Shell,
}

impl Completions {
    /// Prints the script.
    pub fn execute(&self, command: Command, models: &Models) -> Result<(), CommandError> {
        let program = command.get_name().to_owned();
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut named(command, models), program, &mut script);
        Ok(print(&String::from_utf8_lossy(&script))?)
    }
}

/// The same commands with the names that are known only when the program runs.
fn named(command: Command, models: &Models) -> Command {
    let models: Vec<String> = models.iter().map(|model| model.name().to_owned()).collect();
    command.mut_subcommands(|command| {
        command.mut_args(|argument| {
            let id = argument.get_id().as_str();
            if OF_MODELS.contains(&id) {
                argument.value_parser(PossibleValuesParser::new(&models))
            } else if OF_METHODS.contains(&id) {
                argument.value_parser(PossibleValuesParser::new(MethodId::ALL.map(MethodId::name)))
            } else {
                argument
            }
        })
    })
}
