//! The examples that help prints, run as they stand.

use std::collections::HashMap;
use std::path::Path;
use std::process::{Command, Output};

/// Names of the commands of a program.
pub fn find_commands(help: &str) -> Vec<&str> {
    let (_, commands) = help.split_once("Commands:\n").expect("commands");
    let commands = commands.lines().take_while(|line| !line.is_empty());
    // What a description has on further lines stands further in.
    let names = commands.filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    names.filter(|name| !["", "help"].contains(name)).collect()
}

/// The lines of examples in the help of a command.
pub fn find_examples(help: &str) -> Vec<&str> {
    let (_, examples) = help.split_once("Examples:\n").unwrap_or_default();
    let lines = examples.lines().filter_map(|line| line.strip_prefix("  "));
    lines.filter(|line| !line.starts_with(' ')).collect()
}

/// Runs every example of a program in a folder that is empty at first, and returns their standard
/// outputs.
///
/// # Panics
/// If one fails.
pub fn run_examples(program: &Path, folder: &Path) -> HashMap<String, String> {
    std::fs::create_dir(folder).expect("a new folder");
    let help = |arguments: &[&str]| {
        let output = Command::new(program).args(arguments).output().expect("the program starts");
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let all = help(&["help"]);
    let mut commands = find_commands(&all);
    // They write the files that others read.
    commands.sort_by_key(|command| !["new", "run"].contains(command));
    commands.sort_by_key(|command| *command != "new");
    let lines = commands.into_iter().flat_map(|command| {
        let help = help(&[command, "--help"]);
        find_examples(&help).into_iter().map(str::to_owned).collect::<Vec<_>>()
    });
    let path = format!(
        "{}:{}",
        program.parent().expect("a folder").display(),
        std::env::var("PATH").expect("a search path")
    );
    let told = lines.map(|line| {
        // A server ends by Ctrl-C, once: in the background its group would have it twice.
        let is_server = line.contains(" watch ");
        let limited = if is_server { "timeout --foreground --preserve-status -s INT 2 " } else { "" };
        let mut shell = Command::new("sh");
        shell.args(["-c", &format!("{limited}{line}")]).current_dir(folder);
        let output: Output = shell.env("PATH", &path).env("HOME", folder).output().expect("a shell");
        assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
        (line, String::from_utf8(output.stdout).expect("UTF-8"))
    });
    let told = told.collect();
    std::fs::remove_dir_all(folder).expect("removed");
    told
}
