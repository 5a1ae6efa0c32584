//! Archives of arrays of runs and sweeps, read by NumPy where there is it, beside the comma-separated files.

#[path = "../../../models/tests/it/processes/mod.rs"]
mod processes;

mod example;

use example::{FIG_1B, LADDER, SWEEP, liftoff, read_file, refused, refused_by_a_full_disk, run_program};
use processes::folder;
use std::fs;
use std::path::Path;

/// What `read.py` says of FILE.npz beside FILE.csv.
fn in_python(folder: &Path, kind: &str, stem: &str) {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/npz/read.py");
    example::in_python(folder, &["numpy"], [script, kind, stem]);
}

#[test]
fn runs_and_sweeps_read_as_their_comma_separated_tables() {
    let folder = folder("alike");
    for file in ["--csv=run.csv", "--npz=run.npz"] {
        run_program(&folder, &["run", LADDER, "--every=1e-3", "--output=E/(m*g*l)", file]);
    }
    in_python(&folder, "run", "run");
    run_program(&folder, &[&SWEEP[..], &["--csv=sweep.csv", "--npz=sweep.npz"]].concat());
    in_python(&folder, "sweep", "sweep");
}

/// Whether in memory, from a folder of parts, or from shards.
#[test]
fn a_sweep_has_one_file_however_it_was_computed() {
    let folder = folder("merged");
    let with = |options: &[&str]| run_program(&folder, &[&SWEEP[..], options].concat());
    with(&["--csv=whole.csv", "--npz=whole.npz"]);
    with(&["--npz=alone.npz", "--threads=1"]);
    for index in 0..3 {
        with(&["--out=parts", &format!("--shard={index}/3")]);
    }
    run_program(&folder, &["merge", "parts", "--npz=merged.npz"]);
    for other in ["alone.npz", "merged.npz"] {
        assert!(read_file(folder.join(other)) == read_file(folder.join("whole.npz")), "{other}");
    }
}

/// Neither the file nor the temporary one may have so many blocks of 512 bytes, as on a disk that is full.
#[cfg(unix)]
#[test]
fn on_a_full_disk_a_file_is_there_whole_or_as_it_was() {
    let folder = folder("full");
    let run = ["run", LADDER, "--every=1e-3", "--npz=a.npz"];
    run_program(&folder, &run);
    let before = read_file(folder.join("a.npz"));
    for blocks in [0, 1, before.len() / 1024, before.len() / 512] {
        let line = refused_by_a_full_disk(&folder, blocks, &run);
        let ends = line.ends_with("File too large (os error 27)");
        assert!(line.starts_with("error: cannot write a.npz: ") && ends, "{line}");
        assert!(before == read_file(folder.join("a.npz")));
    }
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 1, "nothing is left beside");
}

#[test]
fn mistakes_are_one_line() {
    let folder = folder("mistakes");
    let cases: [(&[&str], &str, i32); 4] = [
        (&["run", LADDER, "--npz=a", "--csv=b"], "--csv and --npz: a run writes its motion to one file", 2),
        (&["run", LADDER, "--npz=a", "--json"], "cannot be used with", 2),
        (&["run", LADDER, "--npz=/dev/null/a"], "cannot write /dev/null/a", 1),
        (
            &["sweep", FIG_1B, "--observe=end", "--observe=end", "--vary=lambda=0:1:3", "--npz=a"],
            "two columns are called `end`",
            2,
        ),
    ];
    for (arguments, expected, code) in cases {
        let (error, found) = refused(&liftoff(&folder, arguments));
        assert!(error.contains(expected) && found == code, "{arguments:?}: {error}");
    }
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0, "nothing is written");
}
