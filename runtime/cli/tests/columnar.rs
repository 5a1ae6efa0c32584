//! Columnar files of runs and sweeps, read by pyarrow, pandas and DuckDB where there are these, beside the comma-separated ones.

#[path = "../../../models/tests/it/processes/mod.rs"]
mod processes;

mod example;

use example::{
    FIG_1B, LADDER, SWEEP, liftoff, program, read_file, refused, refused_by_a_full_disk, run_program,
};
use processes::{folder, text};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

fn with<'a>(options: &[&'a str]) -> Vec<&'a str> {
    [&SWEEP[..], &["--observe=count open"], options].concat()
}

/// What `read.py` says of files with this stem.
fn in_python(folder: &Path, kind: &str, stem: &str) {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/columnar/read.py");
    example::in_python(folder, &["pyarrow", "pandas", "duckdb"], [script, kind, stem]);
}

#[test]
fn a_sweep_reads_as_its_comma_separated_table() {
    let folder = folder("sweep");
    run_program(&folder, &with(&["--csv=a.csv", "--parquet=a.parquet", "--arrow=a.arrow"]));
    in_python(&folder, "sweep", "a");
    // A parameter has its unit.
    let vary = ["sweep", FIG_1B, "--vary=m=0.1:0.9:5", "--observe=end vy(C)", "--csv=b.csv"];
    run_program(&folder, &[&vary[..], &["--parquet=b.parquet", "--arrow=b.arrow"]].concat());
    in_python(&folder, "parameters", "b");
}

#[test]
fn a_run_reads_as_its_comma_separated_table() {
    let folder = folder("run");
    let run = ["run", LADDER, "--every=1e-3", "--output=E/(m*g*l)"];
    for file in ["--csv=a.csv", "--parquet=a.parquet", "--arrow=a.arrow"] {
        run_program(&folder, &[&run[..], &[file]].concat());
    }
    in_python(&folder, "run", "a");
    // Of a run of unknown length some thousand rows; an output that is a column already is no second one.
    for file in ["--csv=b.csv", "--parquet=b.parquet", "--arrow=b.arrow"] {
        run_program(&folder, &["run", LADDER, "--output=E/(m*g*l)", file]);
    }
    in_python(&folder, "run", "b");
    run_program(&folder, &["run", LADDER, "--output=phi", "--output=E/(m*g*l)", "--parquet=c.parquet"]);
    assert!(read_file(folder.join("b.parquet")) == read_file(folder.join("c.parquet")));
}

/// Whether in memory, from a folder of parts, or from shards.
#[test]
fn a_sweep_has_one_file_however_it_was_computed() {
    let folder = folder("merged");
    run_program(&folder, &with(&["--csv=whole.csv", "--parquet=whole.parquet", "--arrow=whole.arrow"]));
    let is_whole = |stem: &str| {
        for form in ["parquet", "arrow"] {
            let same = read_file(folder.join(format!("whole.{form}")))
                == read_file(folder.join(format!("{stem}.{form}")));
            assert!(same, "{stem}.{form}");
        }
    };
    let alone =
        run_program(&folder, &with(&["--parquet=alone.parquet", "--arrow=alone.arrow", "--threads=1"]));
    assert_eq!(alone, "100 members of zigzag from 1 shard, 10 failed\n");
    is_whole("alone");
    assert!(!folder.join("alone.parquet.parts").exists());
    for count in [1, 3] {
        for index in 0..count {
            run_program(&folder, &with(&["--out=parts", &format!("--shard={index}/{count}")]));
        }
        run_program(&folder, &["merge", "parts", "--parquet=merged.parquet", "--arrow=merged.arrow"]);
        is_whole("merged");
        fs::remove_dir_all(folder.join("parts")).expect("removed");
    }
}

#[test]
fn a_sweep_that_was_killed_goes_on_and_ends_alike() {
    let folder = folder("killed");
    let mut sweep = with(&["--parquet=a.parquet", "--threads=1"]);
    (sweep[2], sweep[3]) = ("--vary=lambda=0.05:0.95:20", "--vary=phi0=0.1:1.5:10");
    let journal = folder.join("a.parquet.parts/0-of-1.shard.journal");
    let done = || fs::read_to_string(&journal).map_or(0, |text| text.matches('\n').count());
    let mut command = Command::new(program());
    let mut child = command.current_dir(&folder).args(&sweep).stdout(Stdio::null()).spawn().expect("a child");
    while done() < 50 {
        assert!(child.try_wait().expect("a child").is_none(), "it ended before it was caught");
        sleep(Duration::from_millis(2));
    }
    child.kill().expect("a child");
    child.wait().expect("a child");
    assert!(!folder.join("a.parquet").exists() && done() >= 50);
    run_program(&folder, &sweep);
    let killed = read_file(folder.join("a.parquet"));
    fs::remove_file(folder.join("a.parquet")).expect("removed");
    run_program(&folder, &sweep);
    assert!(killed == read_file(folder.join("a.parquet")));
}

/// Files may have so many blocks of 512 bytes, as on a disk that is full.
#[cfg(unix)]
#[test]
fn on_a_full_disk_a_file_is_there_whole_or_as_it_was() {
    let folder = folder("full");
    for (option, name) in [("--parquet=a.parquet", "a.parquet"), ("--arrow=a.arrow", "a.arrow")] {
        let run = ["run", LADDER, "--every=1e-3", option];
        let before = read_file({
            run_program(&folder, &run);
            folder.join(name)
        });
        for blocks in [0, 1, before.len() / 1024, before.len() / 512] {
            let line = refused_by_a_full_disk(&folder, blocks, &run);
            assert_eq!(line, format!("error: cannot write {name}: File too large (os error 27)"));
            assert!(before == read_file(folder.join(name)));
        }
    }
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 2, "nothing is left beside");
}

#[test]
fn mistakes_are_one_line() {
    let folder = folder("mistakes");
    fs::create_dir(folder.join("taken")).expect("a folder");
    let run = ["run", LADDER];
    let vary = ["sweep", FIG_1B, "--observe=end"];
    let cases: [(&[&str], &[&str], &str, i32); 9] = [
        (&run, &["--parquet=a", "--output=N(Q)"], "no support `Q`", 2),
        (&run, &["--parquet=taken"], "cannot write taken: is a directory", 1),
        (&run, &["--arrow=/dev/null/a"], "cannot write", 1),
        (
            &run,
            &["--parquet=a", "--arrow=b"],
            "--parquet and --arrow: a run writes its motion to one file",
            2,
        ),
        (&run, &["--parquet=a", "--csv=b"], "--csv and --parquet: a run writes its motion to one file", 2),
        (&run, &["--parquet=a", "--json"], "cannot be used with", 2),
        (&vary, &["--vary=lambda=0:1:3", "--observe=end", "--parquet=a"], "two columns are called `end`", 2),
        (
            &vary,
            &["--vary=m=0.1:1:3", "--parquet=a", "--out=parts", "--shard=0/1"],
            "`merge FOLDER --parquet FILE`",
            2,
        ),
        (&["merge", "taken"], &["--parquet=a"], "taken has no shards that are whole", 2),
    ];
    for (command, options, expected, code) in cases {
        let (error, found) = refused(&liftoff(&folder, &[command, options].concat()));
        assert!(error.contains(expected) && found == code, "{options:?}: {error}");
    }
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 1, "nothing is written");
    let told_by = |arguments: &[&str]| refused(&liftoff(&folder, arguments)).0;
    for index in ["0/2", "1/2"] {
        run_program(&folder, &with(&["--out=parts", &format!("--shard={index}")]));
    }
    let twice = told_by(&["merge", "parts", "parts/0-of-2.shard", "--parquet=a"]);
    assert!(twice.contains("parts/0-of-2.shard is shard 0 as parts/0-of-2.shard is"), "{twice}");
    let second = text(&read_file(folder.join("parts/1-of-2.shard")));
    fs::remove_file(folder.join("parts/1-of-2.shard")).expect("removed");
    let missing = told_by(&["merge", "parts", "--parquet=a"]);
    assert!(missing.contains("50 of 100 members are missing: shard 1 is not there"), "{missing}");
    let version = concat!("\"version\":\"", env!("CARGO_PKG_VERSION"), "\"");
    assert!(second.contains(version));
    fs::write(folder.join("parts/1-of-2.shard"), second.replacen(version, "\"version\":\"0.0.1\"", 1))
        .expect("a file");
    let other = told_by(&["merge", "parts", "--parquet=a"]);
    assert!(other.contains("its `version` is \"0.0.1\""), "{other}");
    assert!(!folder.join("a").exists());
}
