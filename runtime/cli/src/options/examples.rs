//! Examples in the help of each command, with the names of the program and of its first model.

use super::defaults;
use clap::Command;
use liftoff_studio::registry::{Entry, Models};
use std::fmt::Write;

/// Command, what to ask of it, what that does. `{model}`, `{parameter}`, `{value}`, `{coordinate}` and `{support}` are those
/// of the first model.
const EXAMPLES: [(&str, &str, &str); 46] = [
    ("list", "list {model}", "one of them with the run that it makes if nothing is said"),
    ("list", "list --json", "all models with their parameters, for another program"),
    ("explain", "explain {model}", "its equations, phase by phase"),
    ("explain", "explain {model} --phase free", "only those without contact"),
    ("explain", "explain {model} --format html --output equations.html", "as a page"),
    ("explain", "explain src/main.rs", "of a file, compiled or not; errors as of the compiler"),
    ("conditions", "conditions {model}", "of all its phases, the motion starting at rest anywhere"),
    (
        "conditions",
        "conditions {model} --from {coordinate}=0.1",
        "from this start, with the places of lift-off",
    ),
    ("export", "export {model} --sympy equations.py", "its equations as a module of Python"),
    ("modes", "modes {model} --dot", "its contact sets as a graph for Graphviz"),
    ("equilibrium", "equilibrium {model}", "from its default start, all contact sets"),
    (
        "equilibrium",
        "equilibrium {model} --set '{parameter}={value}' --json",
        "with all digits, for another program",
    ),
    ("equilibrium", "equilibrium {model} --load '{parameter}'", "and how far the parameter may grow"),
    ("linearise", "linearise {model} --closed free", "about its default start, without contact"),
    ("linearise", "linearise {model} --svg modes.svg", "drawn, each mode moving"),
    ("sensitivity", "sensitivity {model}", "of its default run, by all parameters and its start"),
    (
        "fit",
        "fit {model} --vary '{parameter}' --event 'first open=0.45'",
        "a parameter from the time of the first opening",
    ),
    (
        "fit",
        "fit {model} --vary '{parameter}' --data motion.csv --of '{coordinate}'",
        "the same from a series, with its error",
    ),
    (
        "optimise",
        "optimise {model} --vary '{parameter}={value}/2:2*{value}' --of 'end E' --greatest",
        "the parameter, between bounds, with which the energy at the end is greatest",
    ),
    (
        "orbit",
        "orbit {model} --section 'impact {support}'",
        "from its default start, looked at where a support is struck",
    ),
    (
        "orbit",
        "orbit {model} --section '{coordinate} > 0' --continue '{parameter}=2*{value}'",
        "looked at where the coordinate comes above 0, and followed in a parameter",
    ),
    (
        "boundary",
        "boundary {model} --vary '{parameter}={value}:2*{value}' --vary '{coordinate}=0.1:1' --observe 'first open'",
        "where in this plane another support opens first",
    ),
    ("run", "run {model}", "the default run, event by event"),
    ("run", "run {model} --set '{parameter}={value}' --until 't = 1'", "other parameters, another end"),
    ("run", "run {model} --start '{coordinate}=40deg'", "another start; values may have units"),
    ("run", "run {model} --output 'N({support})' --every 0.1", "a reaction at the events and every 0.1"),
    ("run", "run {model} --csv motion.csv", "the motion as a table"),
    ("plot", "plot {model} --output E --out energy.svg", "an output against time"),
    ("animate", "animate {model} --out motion.html", "the motion as a page"),
    ("watch", "watch swing.rs --open", "in the browser; each save shows the new motion, or what is wrong"),
    ("new", "new crane", "a folder with Cargo.toml and a model, to be compiled"),
    ("run", "run swing.rs", "of a file of Rust that no compiler has seen"),
    ("precision", "precision {model}", "error against run time, every method"),
    ("precision", "precision {model} --methods taylor,dop853 --svg work.svg", "two of them, drawn"),
    ("stability", "stability {model}", "numerical checks of its default run"),
    ("stability", "stability --short energy forms", "two groups of cases, of every model"),
    (
        "sweep",
        "sweep {model} --vary '{parameter}={value}:2*{value}:101' --observe 'first open t'",
        "a parameter varied",
    ),
    (
        "sweep",
        "sweep {model} --vary '{parameter}={value}:2*{value}:101' --observe 'first open t' --out parts --shard 0/2",
        "every second member, for one of two processes",
    ),
    (
        "sweep",
        "sweep {model} --vary '{parameter}={value}:2*{value}:101' --observe 'first open t' --out parts --sbatch job.sh",
        "a script for Slurm",
    ),
    ("merge", "merge parts --csv table.csv", "all parts as one table, or what is missing"),
    ("report", "report {model}", "one page with drawing, equations, run and checks"),
    ("report", "report --out pages", "a page for each model, and their index"),
    ("completions", "completions bash >~/.local/share/bash-completion/completions/{program}", "for bash"),
    ("completions", "completions zsh >~/.zfunc/_{program}", "for zsh"),
    ("completions", "completions fish >~/.config/fish/completions/{program}.fish", "for fish"),
    ("completions", "completions powershell", "for PowerShell"),
];

/// Commands that make a model's default run where nothing else is said.
const RUNNING: [&str; 5] = ["run", "plot", "animate", "precision", "sweep"];

/// The same command with examples in the help of its commands, and in that of a model's run with what it takes where nothing is
/// said.
pub fn with_examples(command: Command, models: &Models) -> Command {
    let names = Names::of(command.get_name(), models);
    let asked = asked(models);
    command.mut_subcommands(|command| {
        let examples = names.examples(command.get_name());
        let runs = RUNNING.contains(&command.get_name());
        let defaults = asked.filter(|_| runs).map(|model| {
            format!("{}, where nothing else is said:\n{}", model.name(), defaults::block(model))
        });
        let texts = defaults.into_iter().chain([examples]).filter(|text| !text.is_empty());
        match texts.collect::<Vec<_>>().join("\n") {
            text if text.is_empty() => command,
            text => command.after_help(text),
        }
    })
}

/// The model that the command line names where it asks for help.
fn asked(models: &Models) -> Option<&Entry> {
    let words: Vec<String> = std::env::args().skip(2).collect();
    let helps = words.iter().any(|word| ["--help", "-h"].contains(&word.as_str()));
    models.iter().find(|model| helps && words.iter().any(|word| word == model.name()))
}

/// What stands in the place of each word in braces.
struct Names(Vec<(&'static str, String)>);

impl Names {
    fn of(program: &str, models: &Models) -> Self {
        let mut names = vec![("{program}", program.to_owned())];
        if let Some(model) = models.iter().next() {
            names.push(("{model}", model.name().to_owned()));
            let (layout, spec) = (model.layout(), model.default_run());
            names.extend(layout.coordinates.first().map(|c| ("{coordinate}", c.name.to_owned())));
            names.extend(layout.contacts.first().map(|c| ("{support}", c.supports[0].to_owned())));
            let parameter = spec.parameters.into_iter().next();
            names.extend(
                parameter
                    .into_iter()
                    .flat_map(|(name, value)| [("{parameter}", name), ("{value}", value.to_string())]),
            );
        }
        Self(names)
    }

    /// The examples of a command that have a name for each of their words.
    fn examples(&self, command: &str) -> String {
        let own = EXAMPLES.iter().filter(|(of, ..)| *of == command);
        let examples = own.filter_map(|(_, line, does)| Some((self.filled(line)?, does)));
        let mut text = String::new();
        for (line, does) in examples {
            let head = if text.is_empty() { "Examples:\n" } else { "" };
            let _ = writeln!(text, "{head}  {line}\n      {does}");
        }
        text
    }

    fn filled(&self, line: &str) -> Option<String> {
        let program = &self.0[0].1;
        let filled = self.0.iter().fold(line.to_owned(), |line, (word, name)| line.replace(word, name));
        (!filled.contains('{')).then(|| format!("{program} {filled}"))
    }
}
