//! Help: examples that can be run, exit codes, no version that is not the program's own.

use crate::program::{errors, run, run_program};

/// The lines of examples in the help of a command, without the program's name.
fn examples(command: &str) -> Vec<String> {
    let help = run_program(&[command, "--help"]);
    let (_, examples) = help.split_once("Examples:\n").unwrap_or_else(|| panic!("{command} has examples"));
    examples.lines().filter_map(|line| line.strip_prefix("  trestle ")).map(str::to_owned).collect()
}

/// Words as a shell would split them; no example needs more than single quotes.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('\'').enumerate();
    let words = parts.flat_map(|(i, part)| match i % 2 {
        0 => part.split(' ').map(str::to_owned).collect(),
        _ => vec![part.to_owned()],
    });
    words.filter(|word| !word.is_empty()).collect()
}

#[test]
fn every_command_has_examples() {
    let help = run_program(&["--help"]);
    let (_, commands) = help.split_once("Commands:\n").expect("commands");
    let commands = commands.lines().take_while(|line| !line.is_empty());
    // What a description has on further lines stands further in.
    let names: Vec<_> = commands.filter_map(|line| line.strip_prefix("  ")?.split(' ').next()).collect();
    assert!(names.len() > 6, "{names:?}");
    for name in names.into_iter().filter(|name| !["", "help"].contains(name)) {
        assert!(!examples(name).is_empty(), "{name}");
    }
}

#[test]
fn examples_of_quick_commands_run_as_they_stand() {
    for command in ["list", "explain", "modes", "run"] {
        let prints = |line: &String| [".csv", ".html", ".svg", ".rs"].iter().all(|file| !line.contains(file));
        for line in examples(command).into_iter().filter(prints) {
            let words = words(&line);
            let output = run(&words.iter().map(String::as_str).collect::<Vec<_>>());
            assert!(output.status.success(), "{line}: {}", errors(&output));
            assert!(!output.stdout.is_empty(), "{line}");
        }
    }
}

#[test]
fn help_tells_the_exit_codes_and_is_what_an_empty_command_line_prints() {
    let help = run_program(&["--help"]);
    assert!(help.contains("Exit codes: 0 done; 1 failed") && help.contains("130"), "{help}");
    assert_eq!(run_program(&[]), help);
}

#[test]
fn a_program_without_a_version_tells_none() {
    let output = run(&["--version"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(errors(&output).contains("'--version'"));
}
