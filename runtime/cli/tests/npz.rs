//! Archives of arrays of runs and sweeps, read by NumPy where there is it, beside the comma-separated files.

#[path = "../../../models/tests/processes/mod.rs"]
mod processes;

mod example;

use example::{liftoff, program, read, refused, told};
use processes::{folder, python_with, text};
use std::fs;
use std::path::Path;
use std::process::Command;

const LADDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../web/gallery/ladder.rs");
const FIG_1B: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../web/gallery/fig_1b.rs");

/// Fig. 1b over λ and φ(0); members with λ > 1 fail, for a mass < 0.
const SWEEP: [&str; 9] = [
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

/// What `read.py` says of FILE.npz beside FILE.csv, where there is a Python that can.
fn in_python(folder: &Path, kind: &str, stem: &str) {
    let Some(python) = python_with(&["numpy"]) else { return };
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/npz/read.py");
    let output =
        Command::new(python).current_dir(folder).args([script, kind, stem]).output().expect("Python");
    assert!(output.status.success(), "{}{}", text(&output.stdout), text(&output.stderr));
}

#[test]
fn runs_and_sweeps_read_as_their_comma_separated_tables() {
    let folder = folder("alike");
    for file in ["--csv=run.csv", "--npz=run.npz"] {
        told(&folder, &["run", LADDER, "--every=1e-3", "--output=E/(m*g*l)", file]);
    }
    in_python(&folder, "run", "run");
    told(&folder, &[&SWEEP[..], &["--csv=sweep.csv", "--npz=sweep.npz"]].concat());
    in_python(&folder, "sweep", "sweep");
}

/// Whether in memory, from a folder of parts, or from shards.
#[test]
fn a_sweep_has_one_file_however_it_was_computed() {
    let folder = folder("merged");
    let with = |options: &[&str]| told(&folder, &[&SWEEP[..], options].concat());
    with(&["--csv=whole.csv", "--npz=whole.npz"]);
    with(&["--npz=alone.npz", "--threads=1"]);
    for index in 0..3 {
        with(&["--out=parts", &format!("--shard={index}/3")]);
    }
    told(&folder, &["merge", "parts", "--npz=merged.npz"]);
    for other in ["alone.npz", "merged.npz"] {
        assert!(read(folder.join(other)) == read(folder.join("whole.npz")), "{other}");
    }
}

/// Neither the file nor the temporary one may have so many blocks of 512 bytes, as on a disk that is full.
#[cfg(unix)]
#[test]
fn on_a_full_disk_a_file_is_there_whole_or_as_it_was() {
    let folder = folder("full");
    let run = ["run", LADDER, "--every=1e-3", "--npz=a.npz"];
    told(&folder, &run);
    let before = read(folder.join("a.npz"));
    for blocks in [0, 1, before.len() / 1024, before.len() / 512] {
        let shell = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" \"$@\"");
        let mut command = Command::new("sh");
        command.args(["-c", &shell]).arg(program()).args(run);
        let output = command.current_dir(&folder).output().expect("a shell");
        let error = text(&output.stderr);
        let line = error.lines().find(|line| line.starts_with("error: ")).expect("an error");
        let ends = line.ends_with("File too large (os error 27)");
        assert!(line.starts_with("error: cannot write a.npz: ") && ends, "{error}");
        assert_eq!(output.status.code(), Some(1));
        assert!(before == read(folder.join("a.npz")));
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
