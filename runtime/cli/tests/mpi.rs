//! Sweeps that the processes of MPI share, killed ones among them.

#[path = "../../../models/tests/it/processes/mod.rs"]
mod processes;

#[allow(dead_code, unused_imports, reason = "tests of files ask for more")]
mod example;

use example::{SWEEP, program, read_file, run_program};
use processes::{folder, text};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// A launch of so many processes, more than there are cores too.
fn mpirun(folder: &Path, count: usize, arguments: &[&str]) -> Command {
    let mut command = Command::new("mpirun");
    command.args(["--oversubscribe", "-n", &count.to_string()]).arg(program()).args(arguments);
    command.current_dir(folder);
    // Containers have no other user.
    command.envs(["OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"].map(|name| (name, "1")));
    command
}

fn shared(folder: &Path, count: usize, arguments: &[&str]) -> String {
    let output = mpirun(folder, count, arguments).output().expect("mpirun, of openmpi-bin");
    assert!(output.status.success(), "{}", text(&output.stderr));
    text(&output.stdout)
}

fn with<'a>(options: &[&'a str]) -> Vec<&'a str> {
    [&SWEEP[..], options].concat()
}

#[test]
fn processes_make_the_table_of_one() {
    let folder = folder("mpi");
    let alone = run_program(&folder, &with(&["--csv=alone.csv"]));
    for count in [2, 3] {
        assert_eq!(shared(&folder, count, &with(&["--csv=shared.csv"])), alone);
        assert!(read_file(folder.join("alone.csv")) == read_file(folder.join("shared.csv")), "{count}");
        shared(&folder, count, &with(&["--out=parts", "--shard=0/1"]));
        run_program(&folder, &["merge", "parts", "--csv=merged.csv"]);
        assert!(read_file(folder.join("alone.csv")) == read_file(folder.join("merged.csv")), "{count}");
        fs::remove_dir_all(folder.join("parts")).expect("removed");
    }
}

/// The process of this rank, by what MPI has put into its environment.
fn rank(launch: &Child, rank: usize) -> Option<u32> {
    let children = format!("/proc/{0}/task/{0}/children", launch.id());
    let variable = format!("OMPI_COMM_WORLD_RANK={rank}");
    let is_it = |id: &&str| {
        let environment = fs::read(format!("/proc/{id}/environ")).unwrap_or_default();
        environment.split(|byte| *byte == 0).any(|entry| entry == variable.as_bytes())
    };
    fs::read_to_string(children).ok()?.split_whitespace().find(is_it)?.parse().ok()
}

#[test]
fn a_sweep_of_which_a_process_was_killed_goes_on_and_ends_alike() {
    let folder = folder("killed");
    let mut sweep = with(&["--csv=a.csv"]);
    (sweep[2], sweep[3]) = ("--vary=lambda=0.05:0.95:40", "--vary=phi0=0.1:1.5:40");
    run_program(&folder, &sweep);
    let whole = read_file(folder.join("a.csv"));
    let journal = folder.join("a.csv.journal");
    let done = || fs::read_to_string(&journal).map_or(0, |text| text.matches('\n').count());
    for killed in [0, 2] {
        fs::remove_file(folder.join("a.csv")).expect("removed");
        let mut launch =
            mpirun(&folder, 3, &sweep).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("mpirun");
        while done() < 50 {
            assert!(launch.try_wait().expect("a child").is_none(), "it ended before it was caught");
            sleep(Duration::from_millis(2));
        }
        let id = rank(&launch, killed).expect("a process of this rank");
        assert!(Command::new("kill").args(["-9", &id.to_string()]).status().expect("kill").success());
        assert!(!launch.wait().expect("a child").success());
        assert!(!folder.join("a.csv").exists() && done() >= 50);
        let told = shared(&folder, 2, &sweep);
        assert!(told.contains(" from the journal"), "{told}");
        assert!(whole == read_file(folder.join("a.csv")), "{killed}");
    }
}

/// Also those that every process finds for itself.
#[test]
fn mistakes_are_reported_once() {
    let folder = folder("mistaken");
    for (mistake, told) in [("--observe=nonsense", "no observation `nonsense`"), ("--threads=0", "--threads")]
    {
        let output = mpirun(&folder, 3, &with(&[mistake])).output().expect("mpirun");
        let error = text(&output.stderr);
        assert!(output.status.code() == Some(2) && error.matches("error: ").count() == 1, "{error}");
        assert!(error.contains(told), "{error}");
    }
}
