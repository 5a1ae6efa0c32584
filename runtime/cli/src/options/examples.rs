//! Examples in the help of each command, with the names of the program and of its first model.

use super::defaults;
use clap::Command;
use liftoff_studio::registry::{Entry, Models};
use std::fmt::Write;

/// Command, a line for a shell, what that does. `{model}`, `{parameter}`, `{value}`, `{coordinate}` and `{support}` are those
/// of the first model; the name of a model in braces is that model, if the program has it; `swing/src/main.rs` is what `new swing` writes.
const EXAMPLES: [(&str, &str, &str); 55] = [
    ("list", "{program} list {model}", "one of them with the run that it makes if nothing is said"),
    ("list", "{program} list --json", "all models with their parameters, for another program"),
    ("explain", "{program} explain {model}", "its equations, phase by phase"),
    ("explain", "{program} explain {model} --phase free", "only those without contact"),
    ("explain", "{program} explain {model} --format html --output equations.html", "as a page"),
    (
        "explain",
        "{program} explain swing/src/main.rs",
        "of a file, compiled or not; errors as of the compiler",
    ),
    ("conditions", "{program} conditions {model}", "of all its phases, the motion starting at rest anywhere"),
    (
        "conditions",
        "{program} conditions {model} --from {coordinate}=0.1",
        "from this start, with the places of lift-off",
    ),
    ("export", "{program} export {model} --sympy equations.py", "its equations as a module of Python"),
    ("modes", "{program} modes {model} --dot", "its contact sets as a graph for Graphviz"),
    ("equilibrium", "{program} equilibrium {model}", "from its default start, all contact sets"),
    (
        "equilibrium",
        "{program} equilibrium {model} --set '{parameter}={value}' --json",
        "with all digits, for another program",
    ),
    (
        "equilibrium",
        "{program} equilibrium {model} --load '{parameter}'",
        "and how far the parameter may grow",
    ),
    ("linearise", "{program} linearise {model} --closed free", "about its default start, without contact"),
    ("linearise", "{program} linearise {model} --svg modes.svg", "drawn, each mode moving"),
    ("sensitivity", "{program} sensitivity {model}", "of its default run, by all parameters and its start"),
    (
        "fit",
        "{program} fit swing/src/main.rs --vary l --until 'phi = 0' --event 'first stop=0.33'",
        "a length from the time at which a condition is met, with its error",
    ),
    (
        "fit",
        "{program} fit swing/src/main.rs --vary l --data swing.csv --of phi",
        "the same from a series, `run swing/src/main.rs --csv swing.csv`",
    ),
    (
        "optimise",
        "{program} optimise swing/src/main.rs --vary 'l=0.4:1.6' --until 't = 1' --of 'end phi'",
        "the length, between bounds, with which the angle after a second is least",
    ),
    (
        "orbit",
        "{program} orbit swing/src/main.rs --section 'phi > 0'",
        "looked at where the coordinate comes above 0",
    ),
    (
        "orbit",
        "{program} orbit {rimless-wheel} --section impact --drift phi --drift x --drift y --continue j=0.2",
        "looked at where a spoke is struck, and followed in a parameter",
    ),
    (
        "boundary",
        "{program} boundary {model} --vary '{parameter}={value}:2*{value}' --vary '{coordinate}=0.1:1' --observe 'first open'",
        "where in this plane another support opens first",
    ),
    ("run", "{program} run {model}", "the default run, event by event"),
    (
        "run",
        "{program} run {model} --set '{parameter}={value}' --until 't = 1'",
        "other parameters, another end",
    ),
    ("run", "{program} run {model} --start '{coordinate}=40deg'", "another start; values may have units"),
    (
        "run",
        "{program} run {model} --output 'N({support})' --every 0.1",
        "a reaction at the events and every 0.1",
    ),
    ("run", "{program} run {model} --csv motion.csv", "the motion as a table"),
    ("run", "{program} run swing/src/main.rs --csv swing.csv", "of a file of Rust that no compiler has seen"),
    ("plot", "{program} plot {model}", "coordinates, reactions and energies against time"),
    ("plot", "{program} plot {model} --output E --out energy.svg", "an output against time"),
    ("plot", "{program} plot {model} --picture drawing --out drawing.svg", "the model with its dimensions"),
    ("plot", "{program} plot {model} --picture pattern --out pattern.svg", "superposed positions"),
    (
        "plot",
        "{program} plot swing/src/main.rs --picture portrait --also phi=1 --also \"phi=0,phi'=5\"",
        "rates against coordinates, of three motions",
    ),
    ("animate", "{program} animate {model} --out motion.html", "the motion as a page"),
    ("animate", "{program} animate {model} --out motion.svg", "as a picture that moves"),
    (
        "watch",
        "{program} watch swing/src/main.rs",
        "serves a page that shows the motion of each save, or what is wrong; --open opens it",
    ),
    ("words", "{program} words", "all words, a line each"),
    ("words", "{program} words spring", "one of them, with its equation and an example"),
    ("new", "{program} new swing", "a folder with Cargo.toml and a model, to be compiled"),
    (
        "new",
        "{program} new my-wheel --from {rimless-wheel}",
        "the same with a copy of a model of this program",
    ),
    ("precision", "{program} precision {model}", "error against run time, every method"),
    ("precision", "{program} precision {model} --methods taylor,dop853 --svg work.svg", "two of them, drawn"),
    ("stability", "{program} stability {model}", "numerical checks of its default run"),
    ("stability", "{program} stability --short energy forms", "two groups of cases, of every model"),
    (
        "sweep",
        "{program} sweep {model} --vary '{parameter}={value}:2*{value}:101' --observe 'first open t'",
        "a parameter varied",
    ),
    (
        "sweep",
        "{program} sweep {model} --vary '{parameter}={value}:2*{value}:101' --observe 'first open t' --out parts --shard 0/2",
        "every second member, for one of two processes",
    ),
    (
        "sweep",
        "{program} sweep {model} --vary '{parameter}={value}:2*{value}:101' --observe 'first open t' --out parts --shard 1/2",
        "the others",
    ),
    (
        "sweep",
        "{program} sweep {model} --vary '{parameter}={value}:2*{value}:101' --observe 'first open t' --out parts --sbatch job.sh",
        "a script for Slurm",
    ),
    ("merge", "{program} merge parts --csv table.csv", "all parts as one table, or what is missing"),
    ("report", "{program} report {model}", "one page with drawing, equations, run and checks"),
    ("report", "{program} report {model} --out pages", "the same in another folder"),
    (
        "completions",
        "D=~/.local/share/bash-completion/completions; mkdir -p $D; {program} completions bash >$D/{program}",
        "for bash",
    ),
    ("completions", "mkdir -p ~/.zfunc && {program} completions zsh >~/.zfunc/_{program}", "for zsh"),
    (
        "completions",
        "mkdir -p ~/.config/fish/completions && {program} completions fish >~/.config/fish/completions/{program}.fish",
        "for fish",
    ),
    ("completions", "{program} completions powershell", "for PowerShell"),
];

/// What to try first.
const FIRST: [(&str, &str); 5] = [
    ("{program} run {model}", "what happens, event by event"),
    ("{program} animate {model} --open", "the motion, in a browser"),
    ("{program} explain {model}", "its equations"),
    ("{program} words", "what can be declared"),
    ("{program} new swing", "a project with a model of one's own"),
];

/// Commands that make a model's default run where nothing else is said.
const RUNNING: [&str; 5] = ["run", "plot", "animate", "precision", "sweep"];

/// The same command with examples in the help of its commands, and in that of a model's run with what it takes where nothing is
/// said.
pub fn with_examples(command: Command, models: &Models) -> Command {
    let names = Names::new(command.get_name(), models);
    let asked = asked(models);
    let first = FIRST.iter().filter_map(|(line, does)| Some((names.filled(line)?, does)));
    let first: String = first.map(|(line, does)| format!("  {line:<36} {does}\n")).collect();
    let command = command.before_help(format!("To try first:\n{first}"));
    command.mut_subcommands(|command| {
        let examples = names.examples(command.get_name());
        let runs = RUNNING.contains(&command.get_name());
        let defaults = asked.filter(|_| runs).map(|model| {
            format!(
                "Coordinates of {name}: {}\n{name}, where nothing else is said:\n{}",
                defaults::measured(model.layout()),
                defaults::block(model),
                name = model.name(),
            )
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
struct Names(Vec<(String, String)>);

impl Names {
    fn new(program: &str, models: &Models) -> Self {
        let mut names = vec![("program", program.to_owned())];
        if let Some(model) = models.iter().next() {
            names.push(("model", model.name().to_owned()));
            let (layout, spec) = (model.layout(), model.default_run());
            names.extend(layout.coordinates.first().map(|c| ("coordinate", c.name.to_owned())));
            names.extend(layout.contacts.first().map(|c| ("support", c.supports[0].to_owned())));
            let parameter = spec.parameters.into_iter().next();
            names.extend(
                parameter
                    .into_iter()
                    .flat_map(|(name, value)| [("parameter", name), ("value", value.to_string())]),
            );
        }
        names.extend(models.iter().map(|model| (model.name(), model.name().to_owned())));
        Self(names.into_iter().map(|(word, name)| (format!("{{{word}}}"), name)).collect())
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
        let filled = self.0.iter().fold(line.to_owned(), |line, (word, name)| line.replace(word, name));
        (!filled.contains('{')).then_some(filled)
    }
}
