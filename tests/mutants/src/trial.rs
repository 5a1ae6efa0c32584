//! Tests against one mutant.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Seconds that a test may take before the long ones.
const SOON: f64 = 0.5;

/// The tests of a binary: how long each takes, and which mutants it reaches.
#[derive(Debug, Default)]
pub struct Plain {
    seconds: BTreeMap<String, f64>,
    reached: BTreeMap<u32, BTreeSet<String>>,
}

/// The end of a mutant.
#[derive(Clone, Debug, PartialEq)]
pub enum Fate {
    /// By a test that fails, an abort, or a time limit.
    Killed(String),
    /// All tests that reach it pass.
    Survived,
    /// No test reaches it.
    Unreached,
}

fn command(binary: &Path, home: &Path) -> Command {
    let mut command = Command::new("sh");
    // A mutant may ask for memory without end.
    command.args(["-c", r#"ulimit -v 6000000; exec "$0" "$@""#]).arg(binary).current_dir(home);
    let root = home.ancestors().find(|folder| folder.join("Cargo.lock").exists()).unwrap_or(home);
    command.env("CARGO_MANIFEST_DIR", home).env("INSTA_UPDATE", "no").env("INSTA_WORKSPACE_ROOT", root);
    command.env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "true").env("PROPTEST_MAX_SHRINK_ITERS", "0");
    command.stdout(Stdio::piped()).stderr(Stdio::null()).stdin(Stdio::null());
    command
}

/// Runs the tests without a mutant.
pub fn plain(binary: &Path, home: &Path, record: &Path) -> Plain {
    let _ = std::fs::remove_file(record);
    let mut command = command(binary, home);
    // Times are told by the test harness of any compiler that believes itself to be a nightly one.
    command.env("LIFTOFF_MUTANTS_REACHED", record).env("RUSTC_BOOTSTRAP", "1");
    command.args(["--test-threads=2", "-Zunstable-options", "--report-time"]);
    let output = command.output().expect("starts the tests");
    let text = String::from_utf8_lossy(&output.stdout);
    // What fails by itself, as a time limit on a busy machine, tells nothing of mutants.
    text.lines()
        .filter(|line| line.contains(" ... FAILED"))
        .for_each(|line| eprintln!("without mutants: {line}"));
    let timed = |line: &str| {
        let (name, time) = line.strip_prefix("test ")?.split_once(" ... ok <")?;
        Some((name.split(" - ").next()?.to_string(), time.strip_suffix("s>")?.parse().ok()?))
    };
    let mut plain = Plain { seconds: text.lines().filter_map(timed).collect(), ..Plain::default() };
    // A library that only tests share has none of its own.
    let has_none = text.contains("running 0 tests");
    assert!(has_none || !plain.seconds.is_empty(), "no test passes without mutants:\n{text}");
    for line in std::fs::read_to_string(record).unwrap_or_default().lines() {
        let Some((id, test)) = line.split_once(' ') else { continue };
        let reached = plain.reached.entry(id.parse().expect("records numbers")).or_default();
        match plain.seconds.contains_key(test) {
            true => _ = reached.insert(test.to_string()),
            // A thread of some test: it may be any.
            false => reached.extend(plain.seconds.keys().cloned()),
        }
    }
    plain
}

/// Runs the tests that reach a mutant, the short ones first, until one fails.
pub fn trial(id: u32, binaries: &[(PathBuf, Plain)], home: &Path) -> Fate {
    let mut fate = Fate::Unreached;
    for soon in [true, false] {
        for (binary, plain) in binaries {
            let Some(reached) = plain.reached.get(&id) else { continue };
            fate = Fate::Survived;
            let tests: Vec<_> =
                reached.iter().filter(|test| (plain.seconds[*test] <= SOON) == soon).collect();
            if tests.is_empty() {
                continue;
            }
            let seconds: f64 = tests.iter().map(|test| plain.seconds[*test]).sum();
            let mut command = command(binary, home);
            command.env("LIFTOFF_MUTANT", id.to_string()).args(["--test-threads=1", "--exact"]).args(&tests);
            if let Some(by) = failure(command, Duration::from_secs_f64(20.0 + 5.0 * seconds)) {
                return Fate::Killed(by);
            }
        }
    }
    fate
}

/// What fails first, if something does.
fn failure(mut command: Command, limit: Duration) -> Option<String> {
    let mut child = command.spawn().expect("starts the tests");
    let (lines, received) = channel();
    let output = BufReader::new(child.stdout.take().expect("reads the tests"));
    std::thread::spawn(move || output.lines().map_while(Result::ok).try_for_each(|line| lines.send(line)));
    let end = Instant::now() + limit;
    let (mut last, mut by) = (String::new(), None);
    while by.is_none() {
        match received.recv_timeout(end.saturating_duration_since(Instant::now())) {
            Ok(line) if line.ends_with(" FAILED") => by = Some(line),
            Ok(line) => last = line,
            Err(RecvTimeoutError::Timeout) => by = Some("the time limit".into()),
            Err(RecvTimeoutError::Disconnected) => break,
        }
    }
    if by.is_some() {
        let _ = child.kill();
    }
    let status = child.wait().expect("waits for the tests");
    by.or_else(|| (!status.success()).then(|| format!("{status} after {last}")))
}
