//! Projects that `new` writes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder of this name that is not there.
fn vacant(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    folder
}

fn run_command(arguments: &[&str]) -> String {
    let output = super::liftoff(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// The file of each model's project runs as the model does, unless attributes cannot say its run.
#[test]
fn every_model_begins_a_project() {
    let mut same = 0;
    for model in liftoff_models::models().iter() {
        let name = format!("new-{}", model.name());
        let folder = vacant(&name);
        run_command(&["new", &name, "--from", model.name()]);
        let file = folder.join("src/main.rs");
        let source = fs::read_to_string(&file).expect("written");
        assert_eq!(source.matches("derive(BarSystem").count(), 1, "{source}");
        let snapshot =
            folder.join(format!("src/snapshots/{}__tests__equations.snap", name.replace('-', "_")));
        let equations = fs::read_to_string(snapshot).expect("written");
        assert!(equations.contains("\n  T = "), "{equations}");
        if !source.contains("impl liftoff_cli::DefaultRun") {
            assert_eq!(
                run_command(&["run", &format!("{name}/src/main.rs")]),
                run_command(&["run", model.name()]),
                "{name}"
            );
            same += 1;
        }
        fs::remove_dir_all(folder).expect("removed");
    }
    assert!(same > 25, "{same}");
}

/// It needs no network, and no word of where the sources are. Minutes: everything is compiled for
/// it.
#[test]
#[ignore = "minutes: `.ci/long new`"]
fn a_new_project_builds_and_passes_its_test() {
    let folder = vacant("thread-project");
    run_command(&["new", "thread-project", "--from", "zigzag-thread"]);
    let cargo = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO"));
        let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("new");
        command
            .args(arguments)
            .current_dir(&folder)
            .env("CARGO_TARGET_DIR", target)
            .env("CARGO_NET_OFFLINE", "true");
        let output = command.output().expect("cargo runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    assert!(cargo(&["test", "--release"]).contains("1 passed"));
    let run = cargo(&["run", "--release", "--", "run", "zigzag-thread"]);
    assert_eq!(run, run_command(&["run", "zigzag-thread"]));
}
