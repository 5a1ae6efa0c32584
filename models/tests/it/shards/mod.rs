//! Shards of a sweep by real processes: as tasks of an array, killed, on a full disk, damaged, and
//! merged.

mod command;
mod kills;

use crate::processes::{folder, text};
use command::{computed, done, liftoff, lines, read_file, refused, run_program, with};
use std::fs;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

#[test]
fn merged_shards_are_the_table_of_one_process() {
    let folder = folder("merged");
    run_program(&folder, &with(&["--csv=whole.csv"]));
    for count in [1, 2, 7] {
        computed(&folder, count);
        let merged = run_program(&folder, &["merge", "parts", "--csv=merged.csv"]);
        assert!(merged.starts_with(&format!("1025 members of zigzag from {count} shard")), "{merged}");
        assert!(read_file(folder.join("whole.csv")) == read_file(folder.join("merged.csv")), "{count}");
        fs::remove_dir_all(folder.join("parts")).expect("removed");
    }
}

#[test]
fn tasks_of_an_array_know_their_shards() {
    let folder = folder("array");
    run_program(&folder, &with(&["--csv=whole.csv"]));
    let task = |id: &str| {
        let mut command = liftoff(&folder, &with(&["--out=parts"]));
        let variables = [("ID", id), ("COUNT", "2"), ("MIN", "1"), ("MAX", "2")];
        command.envs(variables.map(|(name, value)| (format!("SLURM_ARRAY_TASK_{name}"), value)));
        command.output().expect("the command starts")
    };
    assert!(["1", "2"].iter().all(|id| task(id).status.success()));
    run_program(&folder, &["merge", "parts", "--csv=merged.csv"]);
    assert!(read_file(folder.join("whole.csv")) == read_file(folder.join("merged.csv")));
    let (error, code) = refused(&task("3"));
    assert!(error.contains("no shard 2 of 2") && code == 2, "{error}");
}

/// As each process of a launcher of MPI, where the program was built without it.
#[test]
fn processes_of_mpi_are_refused_without_it() {
    let folder = folder("launched");
    let launched = |count: &str| {
        let mut command = liftoff(&folder, &with(&["--csv=whole.csv"]));
        command.env("OMPI_COMM_WORLD_SIZE", count).output().expect("the command starts")
    };
    let (error, code) = refused(&launched("2"));
    assert!(error.contains("OMPI_COMM_WORLD_SIZE") && error.contains("--features mpi"), "{error}");
    assert!(code == 2 && !folder.join("whole.csv").exists());
    assert!(launched("1").status.success());
}

#[cfg(unix)]
#[test]
fn the_script_for_sbatch_computes_all_shards() {
    let folder = folder("sbatch");
    run_program(&folder, &with(&["--csv=whole.csv"]));
    run_program(&folder, &with(&["--out=parts", "--sbatch=job.sh", "--shards=3"]));
    assert!(text(&read_file(folder.join("job.sh"))).contains("#SBATCH --array=0-2\n"));
    // From another folder, as a node has it.
    for id in ["0", "1", "2"] {
        let mut bash = Command::new("bash");
        bash.arg(folder.join("job.sh")).env("SLURM_ARRAY_TASK_ID", id).current_dir(std::env::temp_dir());
        assert!(bash.output().expect("bash").status.success());
    }
    run_program(&folder, &["merge", "parts", "--csv=merged.csv"]);
    assert!(read_file(folder.join("whole.csv")) == read_file(folder.join("merged.csv")));
}

#[test]
fn a_shard_that_was_killed_goes_on_and_ends_alike() {
    let folder = folder("killed");
    let sweep = |out: &'static str| {
        let mut sweep = with(&[out, "--shard=1/2"]);
        (sweep[2], sweep[3]) = ("--vary=lambda=0.02:0.98:60", "--vary=phi0=0.1:1.5:100");
        sweep
    };
    let journal = folder.join("parts/1-of-2.shard.journal");
    for amid in [10, 750] {
        let mut command = liftoff(&folder, &sweep("--out=parts"));
        let mut child = command.stdout(Stdio::null()).spawn().expect("the command starts");
        while lines(&journal) < amid {
            assert!(child.try_wait().expect("a child").is_none(), "it ended before it was caught");
            sleep(Duration::from_millis(2));
        }
        child.kill().expect("a child");
        child.wait().expect("a child");
    }
    let (error, code) = refused(&done(&folder, &["merge", "parts"]));
    assert!(error.contains("has no shards that are whole") && code == 2, "{error}");
    let known = lines(&journal) - 2;
    let rest = run_program(&folder, &sweep("--out=parts"));
    assert!(rest.contains(&format!("3000 members, {} computed, {known} known", 3000 - known)), "{rest}");
    assert!(!journal.exists());
    run_program(&folder, &sweep("--out=whole"));
    assert!(read_file(folder.join("parts/1-of-2.shard")) == read_file(folder.join("whole/1-of-2.shard")));
    assert!(run_program(&folder, &sweep("--out=parts")).contains("0 computed, 3000 known"));
}

/// Files may have so many blocks of 512 bytes, as on a disk that is full: the journal or the file
/// of the shard does not fit.
#[cfg(unix)]
#[test]
fn on_a_full_disk_nothing_that_was_done_is_lost() {
    let folder = folder("full");
    run_program(&folder, &with(&["--out=whole", "--shard=0/1"]));
    let size = read_file(folder.join("whole/0-of-1.shard")).len() / 512;
    for blocks in [0, 1, size / 2, size - 1, size] {
        let shell = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" \"$@\"");
        let mut command = Command::new("sh");
        command
            .args(["-c", &shell, env!("CARGO_BIN_EXE_liftoff")])
            .args(with(&["--out=parts", "--shard=0/1"]));
        let (error, code) = refused(&command.current_dir(&folder).output().expect("a shell"));
        assert!(error.contains("cannot write parts/0-of-1.shard") && code == 1, "{blocks}: {error}");
        assert!(!folder.join("parts/0-of-1.shard").exists());
    }
    assert!(run_program(&folder, &with(&["--out=parts", "--shard=0/1"])).contains(" known"));
    assert!(read_file(folder.join("parts/0-of-1.shard")) == read_file(folder.join("whole/0-of-1.shard")));
}

#[test]
fn missing_or_damaged_shards_are_reported_and_run_again() {
    let folder = folder("gaps");
    computed(&folder, 4);
    let shard = |index: usize| folder.join(format!("parts/{index}-of-4.shard"));
    let whole: Vec<_> = (0..4).map(|index| read_file(shard(index))).collect();
    let merge = || refused(&done(&folder, &["merge", "parts", "--csv=merged.csv"]));
    for length in [0, 10, whole[1].len() / 2, whole[1].len() - 1] {
        fs::write(shard(1), &whole[1][..length]).expect("a file");
        let (error, _) = merge();
        assert!(error.contains("parts/1-of-4.shard is no"), "{length}: {error}");
        run_program(&folder, &with(&["--out=parts", "--shard=1/4"]));
        assert!(read_file(shard(1)) == whole[1], "{length}");
    }
    // A byte of a row, and a shard that is not there.
    let mut damaged = whole[2].clone();
    let row = damaged[..damaged.len() - 200].iter().rposition(|byte| *byte == b'\n').expect("rows") + 1;
    damaged[row] ^= 1;
    fs::write(shard(2), damaged).expect("a file");
    fs::remove_file(shard(3)).expect("removed");
    let (error, code) = merge();
    assert!(
        code == 1
            && error
                .contains("257 of 1025 members are missing: parts/2-of-4.shard is not whole: 1 of its 256"),
        "{error}"
    );
    assert!(error.contains("shard 3 is not there; run again: --shard i/4, --array=2-3"), "{error}");
    assert!(!folder.join("merged.csv").exists());
    assert!(run_program(&folder, &with(&["--out=parts", "--shard=2/4"])).contains("1 computed, 255 known"));
    run_program(&folder, &with(&["--out=parts", "--shard=3/4"]));
    run_program(&folder, &["merge", "parts", "--csv=merged.csv"]);
    assert!((0..4).all(|index| read_file(shard(index)) == whole[index]));
}

#[test]
fn shards_that_do_not_belong_together_are_refused_by_name() {
    let folder = folder("strangers");
    computed(&folder, 2);
    let refused = |arguments: &[&str]| refused(&done(&folder, arguments)).0;
    let merge = |second: &str| refused(&["merge", "parts/0-of-2.shard", second]);
    assert!(merge("parts/0-of-2.shard").contains("parts/0-of-2.shard is shard 0 as parts/0-of-2.shard is"));
    let mut other = with(&["--out=other", "--shard=1/2"]);
    other[2] = "--vary=lambda=0.02:0.98:25";
    run_program(&folder, &other);
    assert!(
        merge("other/1-of-2.shard")
            .contains("other/1-of-2.shard belongs to another sweep than parts/0-of-2.shard: its `vary`")
    );
    let mine = text(&read_file(folder.join("parts/1-of-2.shard")));
    for (word, from, to) in [("version", env!("CARGO_PKG_VERSION"), "0.0.1"), ("model", "zigzag", "zigzog")] {
        let changed = mine.replacen(&format!("\"{word}\":\"{from}\""), &format!("\"{word}\":\"{to}\""), 1);
        fs::write(folder.join("changed.shard"), &changed).expect("a file");
        let error = merge("changed.shard");
        assert!(error.contains(&format!("its `{word}` is \"{to}\", not \"{from}\"")), "{error}");
        fs::write(folder.join("parts/1-of-2.shard"), &changed).expect("a file");
        assert!(
            refused(&with(&["--out=parts", "--shard=1/2"])).contains(&format!("its `{word}` is \"{to}\""))
        );
    }
    assert!(refused(&with(&["--out=parts", "--shard=0/3"])).contains("is of 2 shards, not of 3"));
    fs::write(folder.join("notes.shard"), "my notes\n").expect("a file");
    assert!(merge("notes.shard").contains("notes.shard is not a shard of a sweep"));
}

#[test]
fn mistakes_are_one_line_and_exit_code_2() {
    let folder = folder("mistakes");
    let cases: [(&[&str], &str); 8] = [
        (&["--shard=0/2"], "--shard needs a folder for the shards: say --out FOLDER"),
        (&["--sbatch=job.sh"], "--sbatch needs a folder"),
        (&["--out=parts"], "say --shard i/n"),
        (&["--out=parts", "--shard=2/2"], "no shard 2 of 2: they are numbered from 0 to 1"),
        (&["--out=parts", "--shard=0/0"], "no shards"),
        (&["--out=parts", "--shard=2"], "expected i/n"),
        (&["--out=parts", "--shard=0/2", "--csv=a.csv"], "`merge FOLDER --csv FILE`"),
        (&["--out=parts", "--shards=2"], "--sbatch"),
    ];
    for (options, expected) in cases {
        let (error, code) = refused(&done(&folder, &with(options)));
        assert!(error.contains(expected) && code == 2, "{options:?}: {error}");
    }
    assert!(fs::read_dir(&folder).expect("a folder").next().is_none());
}
