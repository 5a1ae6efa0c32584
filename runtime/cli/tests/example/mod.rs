//! The program that tests of columnar files run.

use crate::processes::text;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The program of an example, which takes files of models.
pub fn program() -> PathBuf {
    let test = std::env::current_exe().expect("a test runs");
    let program = test.ancestors().nth(2).expect("a folder of the build").join("examples/step_ladder");
    assert!(program.exists(), "cargo build -p liftoff-cli --example step_ladder --features parquet,npz");
    program
}

pub fn liftoff(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(program());
    command.current_dir(folder).args(arguments).output().expect("the command starts")
}

pub fn told(folder: &Path, arguments: &[&str]) -> String {
    let output = liftoff(folder, arguments);
    assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

/// One line, and the exit code.
pub fn refused(output: &Output) -> (String, i32) {
    let error = text(&output.stderr);
    assert_eq!(error.trim_end().lines().count(), 1, "{error}");
    (error, output.status.code().expect("a code"))
}

pub fn read(path: PathBuf) -> Vec<u8> {
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
