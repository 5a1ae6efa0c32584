//! How much memory long runs take: what they print and write is taken while they go on.

use crate::processes::{folder, text};
use std::path::Path;
use std::process::Command;

/// Runs the double pendulum for so long in an address space of 140 MB, up to 100 of which the
/// program, its threads and its allocator set apart.
fn in_140_megabytes(folder: &Path, seconds: &str, options: &[&str]) -> usize {
    let shell = "ulimit -v 140000; exec \"$0\" \"$@\"";
    let mut command = Command::new("sh");
    command.args(["-c", shell, env!("CARGO_BIN_EXE_liftoff"), "run", "double-pendulum", "--limit=1e6"]);
    command.arg(format!("--until=t = {seconds}")).args(options).current_dir(folder);
    let output = command.output().expect("a shell");
    assert!(output.status.success(), "{options:?}: {}", text(&output.stderr));
    text(&output.stdout).lines().count()
}

/// 3000 seconds that are kept are 80 MB, as 100,000 were 2.8 GB.
#[cfg(target_os = "linux")]
#[test]
fn long_runs_take_no_more_memory_than_short_ones() {
    let folder = folder("long");
    assert_eq!(in_140_megabytes(&folder, "3000", &[]), 2);
    assert_eq!(in_140_megabytes(&folder, "3000", &["--csv=coarse.csv"]), 2);
    // 300,000 rows of 9 columns are in the file and nowhere else.
    let printed = in_140_megabytes(&folder, "3000", &["--every=0.01", "--output=E", "--csv=fine.csv"]);
    assert_eq!(printed, 3);
    let rows = text(&std::fs::read(folder.join("fine.csv")).expect("a file")).lines().count();
    assert_eq!(rows, 300_002);
    // 60,000 rows that are printed.
    assert_eq!(in_140_megabytes(&folder, "600", &["--every=0.01"]), 60_002);
}
