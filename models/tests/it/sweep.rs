//! The command `sweep` as its users meet it: killed, interrupted and gone on with, from a file,
//! with mistakes.

use crate::processes::{folder, text};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::Duration;

fn liftoff(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_liftoff"));
    command.current_dir(folder).arg("sweep").args(arguments);
    command
}

fn done(folder: &Path, arguments: &[&str]) -> Output {
    liftoff(folder, arguments).output().expect("the command starts")
}

/// Enough members for a process to be caught amid them.
const SWEEP: [&str; 13] = [
    "zigzag",
    "--vary",
    "lambda=0.02:0.98:100",
    "--vary",
    "phi0=0.1:1.5:60",
    "--set=m1=1-lambda",
    "--set=m2=lambda",
    "--start=phi_inner=phi0",
    "--start=phi_outer=phi0",
    "--observe=first open",
    "--observe=first open phi_inner",
    "--observe=end",
    "--csv=out.csv",
];

fn lines(path: &Path) -> usize {
    fs::read_to_string(path).map_or(0, |text| text.matches('\n').count())
}

/// Starts the sweep, and stops waiting once its journal has this many lines.
fn caught(folder: &Path, amid: usize) -> Child {
    let mut command = liftoff(folder, &SWEEP);
    let mut child =
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts");
    while lines(&folder.join("out.csv.journal")) < amid {
        assert!(child.try_wait().expect("a child").is_none(), "it ended before it was caught");
        sleep(Duration::from_millis(5));
    }
    child
}

#[test]
fn a_sweep_that_was_killed_goes_on_and_ends_alike() {
    let (whole, killed) = (folder("whole"), folder("killed"));
    assert!(done(&whole, &SWEEP).status.success());
    for amid in [10, 900] {
        let mut child = caught(&killed, amid);
        child.kill().expect("a child");
        child.wait().expect("a child");
        assert!(!killed.join("out.csv").exists());
    }
    let known = lines(&killed.join("out.csv.journal")) - 2;
    let rest = done(&killed, &SWEEP);
    let told = text(&rest.stdout);
    assert!(
        told.starts_with(&format!(
            "6000 members of zigzag: {} computed, {known} from the journal",
            6000 - known
        )),
        "{told}"
    );
    let csv = |folder: &Path| fs::read(folder.join("out.csv")).expect("a table");
    assert!(csv(&whole) == csv(&killed));
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_is_done_and_says_how_to_go_on() {
    let folder = folder("interrupted");
    let child = caught(&folder, 100);
    let signal = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(signal.expect("kill starts").success());
    let output = child.wait_with_output().expect("a child");
    assert_eq!(output.status.code(), Some(130));
    let (told, error) = (text(&output.stdout), text(&output.stderr));
    assert!(told.contains("not run\n"), "{told}");
    assert!(error.contains("the same command resumes from out.csv.journal"), "{error}");
    let computed: usize = told.split_whitespace().nth(4).and_then(|word| word.parse().ok()).expect("a count");
    assert_eq!(lines(&folder.join("out.csv.journal")), computed + 2);
}

#[test]
fn a_file_says_what_options_say() {
    let folder = folder("file");
    let file = "model = 'zigzag'\nobserve = ['first open', 'first open phi_inner']\ncsv = 'file.csv'\nsvg = 'file.svg'\n\
                [vary]\nlambda = '0.1:0.9:5'\n[set]\nm1 = '1-lambda'\nm2 = 'lambda'\n";
    fs::write(folder.join("runs.toml"), file).expect("a file");
    let file = Path::new(folder.file_name().expect("a name")).join("runs.toml");
    let output = done(folder.parent().expect("a parent"), &[&file.to_string_lossy()]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let options =
        ["zigzag", "--vary=lambda=0.1:0.9:5", "--set=m1=1-lambda", "--set=m2=lambda", "--observe=first open"];
    let output =
        done(&folder, &[&options[..], &["--observe=first open phi_inner", "--csv=options.csv"]].concat());
    assert!(output.status.success(), "{}", text(&output.stderr));
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect("a file");
    assert_eq!(read("file.csv"), read("options.csv"));
    assert!(read("file.svg").starts_with("<svg"));
}

#[test]
fn mistakes_are_one_line_and_exit_code_2() {
    let folder = folder("mistakes");
    fs::write(folder.join("wrong.toml"), "model = 'zigzag'\nobserv = 'end'\n").expect("a file");
    fs::write(folder.join("torn.toml"), "model = 'zigzag'\nvary = [\n").expect("a file");
    let vary = "--vary=m1=0.1:0.9:3";
    let cases: [(&[&str], &str, i32); 13] = [
        (&["zigzg", vary, "--observe=end"], "did you mean `zigzag`?", 2),
        (&["zigzag", "--vary=m3=0:1:3", "--observe=end"], "did you mean `m1`?", 2),
        (&["zigzag", vary, "--set=m4=1", "--observe=end"], "no parameter `m4`; did you mean `m1`?", 2),
        (&["zigzag", vary, "--observe=first opne"], "did you mean `open`?", 2),
        (&["zigzag", vary, "--observe=end phi_inne"], "did you mean `phi_inner`?", 2),
        (&["zigzag", "--vary=m1=1:0:3", "--observe=end"], "is reversed", 2),
        (&["zigzag", "--vary=m1=1:1:3", "--observe=end"], "is empty", 2),
        (
            &["zigzag", "--vary=phi_inner=10degs:20deg:3", "--observe=end"],
            "no unit `degs`; did you mean `deg`?",
            2,
        ),
        (&["zigzag", vary, "--observe=end", "--csv=none/out.csv"], "cannot write none/out.csv", 1),
        (&["zigzag", vary, "--observe=end", "--seed=1"], "a seed needs --random or --sobol", 2),
        (&["wrong.toml"], "no key `observ`; did you mean `observe`?", 2),
        (&["torn.toml"], "torn.toml: line ", 2),
        (&["absent.toml"], "cannot read absent.toml", 1),
    ];
    for (arguments, told, code) in cases {
        let output = done(&folder, arguments);
        let error = text(&output.stderr);
        assert!(error.contains(told) && error.trim_end().lines().count() == 1, "{arguments:?}: {error}");
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {error}");
    }
}

/// λ = ¼: N_C = 6 N_E whatever the angle (Fig. 1b, strict).
#[test]
fn a_threshold_is_narrowed_down() {
    let sets = ["--set=m1=1-lambda", "--set=m2=lambda", "--observe=first open", "--to=1e-9"];
    let output = done(&folder("bisect"), &[&["zigzag", "--bisect=lambda=0.1:0.9:4"][..], &sets].concat());
    let told = text(&output.stdout);
    assert!(output.status.success() && told.contains("A, E | ") && told.contains(" | C\n"), "{told}");
    let first = told.lines().nth(1).and_then(|line| line.split_whitespace().nth(2)).expect("a threshold");
    assert!((first.parse::<f64>().expect("a number") - 0.25).abs() < 1e-8, "{told}");
}
