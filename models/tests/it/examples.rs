//! The examples in the help of `liftoff`.

// Only what runs them is used here.
#[path = "../../../tests/program/tests/command/examples.rs"]
mod runner;

use std::path::Path;

#[test]
fn every_example_runs_as_it_stands() {
    let folder = std::env::temp_dir().join(format!("liftoff-examples-{}", std::process::id()));
    let told = runner::run_examples(Path::new(env!("CARGO_BIN_EXE_liftoff")), &folder);
    assert!(told.keys().any(|line| line.contains("rimless-wheel")), "{told:?}");
}
