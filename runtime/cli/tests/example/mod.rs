//! The program that tests of columnar files run, and a sweep for it.

#[path = "../../../../models/tests/it/processes/outcome.rs"]
mod outcome;

pub use outcome::{read_file, refused};

use crate::processes::{python_with, text};
use outcome::succeeded;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub const LADDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../web/gallery/ladder.rs");
pub const FIG_1B: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../web/gallery/fig_1b.rs");

/// Fig. 1b over λ and φ(0); members with λ > 1 fail, for a mass < 0.
pub const SWEEP: [&str; 9] = [
    "sweep",
    FIG_1B,
    "--vary=lambda=0.15:1.05:10",
    "--vary=phi0=0.1:1.5:10",
    "--start=phi_inner=phi0",
    "--start=phi_outer=phi0",
    "--observe=first open",
    "--observe=first open phi_inner",
    "--observe=end",
];

/// The program of an example, which takes files of models.
pub fn program() -> PathBuf {
    let test = std::env::current_exe().expect("a test runs");
    let program = test.ancestors().nth(2).expect("a folder of the build").join("examples/step_ladder");
    assert!(program.exists(), "cargo build -p liftoff-cli --example step_ladder --features parquet,npz,mpi");
    program
}

pub fn liftoff(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(program());
    command.current_dir(folder).args(arguments).output().expect("the command starts")
}

pub fn run_program(folder: &Path, arguments: &[&str]) -> String {
    succeeded(&liftoff(folder, arguments), arguments)
}

/// The line of an error where no file may have more blocks of 512 bytes, as on a disk that is full.
#[cfg(unix)]
pub fn refused_by_a_full_disk(folder: &Path, blocks: usize, arguments: &[&str]) -> String {
    let shell = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" \"$@\"");
    let mut command = Command::new("sh");
    command.args(["-c", &shell]).arg(program()).args(arguments);
    let output = command.current_dir(folder).output().expect("a shell");
    assert_eq!(output.status.code(), Some(1));
    let error = text(&output.stderr);
    let line = error.lines().find(|line| line.starts_with("error: "));
    line.unwrap_or_else(|| panic!("no error: {error}")).to_owned()
}

/// What a script says of files, where there is a Python that has the packages.
pub fn in_python(folder: &Path, packages: &[&str], arguments: [&str; 3]) {
    let Some(python) = python_with(packages) else { return };
    let output = Command::new(python).current_dir(folder).args(arguments).output().expect("Python");
    assert!(output.status.success(), "{}{}", text(&output.stdout), text(&output.stderr));
    println!("{}", text(&output.stdout));
}
