//! What a process has said that has ended, and what it has written.

use crate::processes::text;
use std::fs;
use std::path::PathBuf;
use std::process::Output;

/// What it says where it succeeds.
pub fn succeeded(output: &Output, arguments: &[&str]) -> String {
    assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

/// One line, and the exit code.
pub fn refused(output: &Output) -> (String, i32) {
    let error = text(&output.stderr);
    assert_eq!(error.trim_end().lines().count(), 1, "{error}");
    (error, output.status.code().expect("a code"))
}

pub fn read_file(path: PathBuf) -> Vec<u8> {
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
