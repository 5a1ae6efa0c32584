//! The program, run.

use std::path::PathBuf;
use std::process::{Command, Output};

/// The program with these arguments, away from the repository and from the colours of whoever runs
/// the tests.
pub fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_trestle"));
    for name in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"] {
        command.env_remove(name);
    }
    command.args(arguments).current_dir(std::env::temp_dir());
    command
}

pub fn run(arguments: &[&str]) -> Output {
    command(arguments).output().expect("the program starts")
}

/// What it prints if all goes well.
pub fn run_program(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", errors(&output));
    String::from_utf8(output.stdout).expect("UTF-8")
}

pub fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A place for a file or directory of one test.
pub fn temporary_path(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("liftoff-program-{}-{name}", std::process::id()))
}
