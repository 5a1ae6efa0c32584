//! The command, and a sweep for it.

#[path = "../processes/outcome.rs"]
mod outcome;

pub use outcome::{read_file, refused};

use outcome::succeeded;
use std::fs;
use std::path::Path;
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

pub fn run_program(folder: &Path, arguments: &[&str]) -> String {
    succeeded(&done(folder, arguments), arguments)
}

/// Fig. 1b over λ and φ(0); members with λ > 1 fail, for m₁ < 0.
pub const SWEEP: [&str; 12] = [
    "sweep",
    "zigzag",
    "--vary=lambda=0:1.05:25",
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

/// All shards of so many.
pub fn computed(folder: &Path, count: usize) {
    for index in 0..count {
        run_program(folder, &with(&["--out=parts", &format!("--shard={index}/{count}")]));
    }
}

pub fn lines(path: &Path) -> usize {
    fs::read_to_string(path).map_or(0, |text| text.matches('\n').count())
}
