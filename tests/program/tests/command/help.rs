//! Help: examples that can be run, exit codes, no version that is not the program's own.

use crate::examples::{find_commands, find_examples, run_examples};
use crate::program::{errors, run, run_program, temporary_path};
use std::path::Path;

#[test]
fn every_command_has_examples() {
    let help = run_program(&["--help"]);
    let names = find_commands(&help);
    assert!(names.len() > 6, "{names:?}");
    for name in names {
        assert!(!find_examples(&run_program(&[name, "--help"])).is_empty(), "{name}");
    }
}

#[test]
fn every_example_runs_as_it_stands() {
    let told = run_examples(Path::new(env!("CARGO_BIN_EXE_trestle")), &temporary_path("examples"));
    assert!(told.len() > 40, "{}", told.len());
    for quick in [
        "trestle list trestle",
        "trestle explain trestle",
        "trestle modes trestle --dot",
        "trestle run trestle",
    ] {
        assert!(!told[quick].is_empty(), "{quick}");
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
