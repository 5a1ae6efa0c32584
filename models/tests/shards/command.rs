//! The command, and a sweep for it.

use crate::processes::text;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub fn liftoff(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_liftoff"));
    for name in ["ID", "COUNT", "MIN", "MAX"] {
        command.env_remove(format!("SLURM_ARRAY_TASK_{name}"));
    }
    command.current_dir(folder).args(arguments);
    command
}

pub fn done(folder: &Path, arguments: &[&str]) -> Output {
    liftoff(folder, arguments).output().expect("the command starts")
}

pub fn told(folder: &Path, arguments: &[&str]) -> String {
    let output = done(folder, arguments);
    assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

/// One line, and the exit code.
pub fn refused(output: &Output) -> (String, i32) {
    let error = text(&output.stderr);
    assert_eq!(error.trim_end().lines().count(), 1, "{error}");
    (error, output.status.code().expect("a code"))
}

/// Fig. 1b over λ and φ(0); members with λ > 1 fail, for m₁ < 0.
pub const SWEEP: [&str; 12] = [
    "sweep",
    "zigzag",
    "--vary=lambda=0:1.05:50",
    "--vary=phi0=0.1:1.5:41",
    "--set=m1=1-lambda",
    "--set=m2=lambda",
    "--start=phi_inner=phi0",
    "--start=phi_outer=phi0",
    "--observe=first open",
    "--observe=first open phi_inner",
    "--observe=end",
    "--threads=1",
];

pub fn with<'a>(options: &[&'a str]) -> Vec<&'a str> {
    [&SWEEP[..], options].concat()
}

pub fn read(path: PathBuf) -> Vec<u8> {
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All shards of so many.
pub fn computed(folder: &Path, count: usize) {
    for index in 0..count {
        told(folder, &with(&["--out=parts", &format!("--shard={index}/{count}")]));
    }
}

pub fn lines(path: &Path) -> usize {
    fs::read_to_string(path).map_or(0, |text| text.matches('\n').count())
}
