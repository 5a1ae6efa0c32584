//! Processes killed at any moment, disks that are full, folders that cannot be written: what was
//! done is there, and the end is the same.

use super::command::{done, liftoff, lines, read_file, refused, run_program, with};
use crate::processes::{folder, text};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A number in 0..1.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

/// Kills a process after so long a time; whether it was still running.
fn killed(mut child: Child, after: Duration) -> bool {
    let begin = Instant::now();
    while begin.elapsed() < after {
        if let Some(status) = child.try_wait().expect("a child") {
            assert!(status.success(), "{status}");
            return false;
        }
        sleep(Duration::from_millis(1));
    }
    child.kill().expect("a child");
    !child.wait().expect("a child").success()
}

fn quiet(folder: &Path, arguments: &[&str]) -> Child {
    let mut command = liftoff(folder, arguments);
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the command starts")
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder").flatten();
    let mut names: Vec<_> = entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// How many members a sweep says that it knew.
fn known(told: &str) -> usize {
    let count = told.split(", ").find_map(|part| part.trim_end().strip_suffix(" known"));
    count.map_or(0, |count| count.parse().expect("a number"))
}

/// The sweep with so many members that a kill finds some of them done.
fn long<'a>(options: &[&'a str]) -> Vec<&'a str> {
    let finer = |word: &'a str| match word {
        "--vary=lambda=0:1.05:25" => "--vary=lambda=0:1.05:105",
        "--vary=phi0=0.1:1.5:41" => "--vary=phi0=0.1:1.5:141",
        word => word,
    };
    with(options).into_iter().map(finer).collect()
}

const SHARDS: usize = 3;

/// Each shard is killed again and again, at any of its moments, those of its beginning and its end
/// most of all, until it has got through; what is a whole line of its journal then is there ever
/// after.
#[test]
fn shards_killed_at_any_moment_lose_nothing_and_end_alike() {
    let folder = folder("any-moment");
    run_program(&folder, &long(&["--csv=whole.csv"]));
    let shard = |index: usize, out: &str| ["--out=".to_owned() + out, format!("--shard={index}/{SHARDS}")];
    let begin = Instant::now();
    let [out, index] = shard(0, "timed");
    run_program(&folder, &long(&[&out, &index]));
    let takes = begin.elapsed();
    let (mut seed, mut kills, mut resumed) = (7, 0, 0);
    for index in 0..SHARDS {
        let journal = folder.join(format!("parts/{index}-of-{SHARDS}.shard.journal"));
        let options = shard(index, "parts");
        let sweep = long(&[&options[0], &options[1]]);
        for round in 0..15 {
            let known = lines(&journal).saturating_sub(2);
            let share = match round % 3 {
                0 => 0.1 * random(&mut seed),
                _ => 1.2 * random(&mut seed),
            };
            if !killed(quiet(&folder, &sweep), takes.mul_f64(share)) {
                // It has got through; once more from its beginning.
                let file = folder.join(format!("parts/{index}-of-{SHARDS}.shard"));
                fs::remove_file(file).expect("a whole shard");
                assert!(!journal.exists());
                continue;
            }
            kills += 1;
            let file = folder.join(format!("parts/{index}-of-{SHARDS}.shard"));
            if file.exists() {
                // Killed between the file's last name and the end of its journal, or of itself.
                continue;
            }
            assert!(lines(&journal).saturating_sub(2) >= known, "{index} {round}");
            resumed += usize::from(known > 0);
        }
        let known = lines(&journal).saturating_sub(2);
        let last = run_program(&folder, &sweep);
        let there = folder.join(format!("parts/{index}-of-{SHARDS}.shard"));
        assert!(there.exists() && !journal.exists());
        assert!(self::known(&last) >= known, "{last}");
    }
    println!("{kills} kills, {resumed} of what had been begun");
    assert!(kills >= 15 && resumed >= 5, "{kills} {resumed}");
    let expected: Vec<String> = (0..SHARDS).map(|index| format!("{index}-of-{SHARDS}.shard")).collect();
    assert_eq!(names(&folder.join("parts")), expected, "nothing is left beside");
    // So is the merging of them.
    for _ in 0..10 {
        let takes = Duration::from_secs_f64(0.05 * random(&mut seed));
        killed(quiet(&folder, &["merge", "parts", "--csv=merged.csv"]), takes);
        let there = folder.join("merged.csv");
        assert!(!there.exists() || read_file(there) == read_file(folder.join("whole.csv")));
    }
    run_program(&folder, &["merge", "parts", "--csv=merged.csv"]);
    assert!(read_file(folder.join("whole.csv")) == read_file(folder.join("merged.csv")));
}

/// A journal that ends anywhere, as one of a machine that has lost its power.
#[test]
fn a_journal_cut_anywhere_goes_on() {
    let folder = folder("cut");
    run_program(&folder, &with(&["--out=whole", "--shard=0/8"]));
    let whole = read_file(folder.join("whole/0-of-8.shard"));
    fs::create_dir(folder.join("parts")).expect("a folder");
    let head = whole.iter().enumerate().filter(|(_, byte)| **byte == b'\n').nth(1).expect("two lines").0 + 1;
    let mut seed = 3;
    let anywhere = (0..6).map(|_| (random(&mut seed) * whole.len() as f64) as usize);
    let lengths = [0, 1, head / 2, head - 1, head, head + 1].into_iter().chain(anywhere);
    for length in lengths.collect::<Vec<_>>() {
        fs::write(folder.join("parts/0-of-8.shard.journal"), &whole[..length]).expect("a file");
        let told = run_program(&folder, &with(&["--out=parts", "--shard=0/8"]));
        let ends = whole[..length].iter().filter(|byte| **byte == b'\n').count();
        assert_eq!(self::known(&told), ends.saturating_sub(2), "{length}: {told}");
        assert!(read_file(folder.join("parts/0-of-8.shard")) == whole, "{length}");
        fs::remove_file(folder.join("parts/0-of-8.shard")).expect("removed");
    }
}

/// A file system of a size, where this process may mount one; gone with this.
struct Disk<'a>(&'a Path);

impl<'a> Disk<'a> {
    fn mount(folder: &'a Path, kilobytes: usize) -> Option<Self> {
        let size = format!("size={kilobytes}k");
        let mut mount = Command::new("mount");
        let output = mount.args(["-t", "tmpfs", "-o", &size, "tmpfs"]).arg(folder).output();
        output.is_ok_and(|output| output.status.success()).then_some(Self(folder))
    }
}

impl Drop for Disk<'_> {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(self.0).output();
    }
}

/// On a disk that is full at any place; where it grows, the sweep goes on.
#[cfg(target_os = "linux")]
#[test]
fn a_sweep_goes_on_when_there_is_room_again() {
    let folder = folder("disk");
    run_program(&folder, &with(&["--out=whole", "--shard=0/1"]));
    let whole = read_file(folder.join("whole/0-of-1.shard"));
    let disk = folder.join("disk");
    fs::create_dir(&disk).expect("a folder");
    let needed = 2 * whole.len() / 1024;
    let Some(_mounted) = Disk::mount(&disk, 8) else {
        eprintln!("skipped: a disk cannot be mounted here");
        return;
    };
    let sweep = with(&["--out=disk/parts", "--shard=0/1"]);
    let mut known = 0;
    for kilobytes in [8, needed / 4, needed / 2, needed - 16] {
        let mut remount = Command::new("mount");
        remount.args(["-o", &format!("remount,size={kilobytes}k")]).arg(&disk);
        assert!(remount.status().expect("mount").success());
        let (error, code) = refused(&done(&folder, &sweep));
        assert!(error.contains("cannot write disk/parts") && code == 1, "{error}");
        assert!(error.contains("No space left on device"), "{error}");
        let journal = lines(&disk.join("parts/0-of-1.shard.journal"));
        assert!(journal >= known && !disk.join("parts/0-of-1.shard").exists(), "{kilobytes}");
        known = journal;
    }
    assert!(known > 500, "{known}");
    let mut remount = Command::new("mount");
    assert!(remount.args(["-o", "remount,size=4m"]).arg(&disk).status().expect("mount").success());
    let told = run_program(&folder, &sweep);
    assert!(self::known(&told) >= known - 3, "{told}");
    assert!(read_file(disk.join("parts/0-of-1.shard")) == whole);
}

#[cfg(unix)]
#[test]
fn folders_that_cannot_be_written_are_reported_by_name() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder("unwritable");
    fs::write(folder.join("file"), "").expect("a file");
    let told_of = |out: &str| {
        let (error, code) = refused(&done(&folder, &with(&[&format!("--out={out}"), "--shard=0/1"])));
        assert!(error.contains(out) && code == 1, "{error}");
        error
    };
    assert!(told_of("file/parts").contains("Not a directory"));
    assert!(told_of("/proc/parts").contains("cannot write /proc/parts"));
    fs::create_dir_all(folder.join("parts/0-of-1.shard")).expect("a folder");
    assert!(told_of("parts").contains("parts/0-of-1.shard"));
    fs::create_dir(folder.join("closed")).expect("a folder");
    fs::set_permissions(folder.join("closed"), fs::Permissions::from_mode(0o555)).expect("a folder");
    // Root may write everywhere.
    if fs::write(folder.join("closed/tried"), "").is_err() {
        assert!(told_of("closed").contains("Permission denied"));
    }
    let (error, code) = refused(&done(&folder, &["merge", "/proc/1/none"]));
    assert!(error.contains("/proc/1/none") && code != 0, "{error}");
    assert_eq!(text(&read_file(folder.join("file"))), "");
}
