//! Ctrl-C keeps the results so far.
#![cfg(unix)]

use crate::program::{command, errors, temporary_path};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

fn begin(arguments: &[&str]) -> Child {
    command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

fn interrupt(child: &Child) {
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(sent.expect("there is `kill`").success());
}

/// The output of a command that is interrupted after it has run for a while.
fn interrupted(arguments: &[&str]) -> Output {
    let mut child = begin(arguments);
    sleep(Duration::from_millis(700));
    assert!(child.try_wait().expect("a child").is_none(), "{arguments:?}: it is over before");
    interrupt(&child);
    let pressed = Instant::now();
    let output = child.wait_with_output().expect("it ends");
    assert!(pressed.elapsed() < Duration::from_secs(60));
    output
}

#[test]
fn a_run_prints_and_writes_the_motion_so_far() {
    let file = temporary_path("motion.csv");
    let path = file.to_str().expect("UTF-8");
    let endless = ["run", "trestle", "--until", "t = 1e7", "--limit", "1e8", "--csv", path];
    let output = interrupted(&endless);
    let written = std::fs::read_to_string(&file).expect("the motion so far");
    std::fs::remove_file(&file).expect("removed");
    assert_eq!(output.status.code(), Some(130), "{}", errors(&output));
    assert!(String::from_utf8_lossy(&output.stdout).starts_with("start at t = 0, alpha = 1.318"));
    assert!(errors(&output).contains("interrupted at t = "), "{}", errors(&output));
    assert!(written.lines().count() > 1000);
}

#[test]
fn precision_prints_the_rows_that_it_has() {
    let output = interrupted(&["precision", "trestle", "--measuring", "300"]);
    assert_eq!(output.status.code(), Some(130), "{}", errors(&output));
    let rows = String::from_utf8_lossy(&output.stdout).lines().count();
    assert!((2..60).contains(&rows), "{rows}");
    assert!(errors(&output).contains("interrupted after"), "{}", errors(&output));
}

/// The time from Ctrl-C to the end of the command.
fn reaction(arguments: &[&str]) -> (Output, Duration) {
    let mut child = begin(arguments);
    sleep(Duration::from_millis(300));
    assert!(child.try_wait().expect("a child").is_none(), "{arguments:?}: it is over before");
    interrupt(&child);
    let pressed = Instant::now();
    (child.wait_with_output().expect("it ends"), pressed.elapsed())
}

/// A model whose default run takes minutes.
const ENDLESS: &str = r#"
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (l, 0), B = (2 * l, 0))]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(AB), from = down)]
#[run(start = "phi = 2, psi = 3", until = "t = 1e6")]
struct Endless {
    #[value(1)]
    m: f64,
    #[value(1)]
    l: f64,
    #[value(9.81)]
    g: f64,
}
"#;

/// Commands that take minutes end at once, in any of their stages.
#[test]
fn reports_and_stability_end_within_a_second() {
    let directory = temporary_path("left");
    std::fs::create_dir_all(&directory).expect("made");
    let file = directory.join("endless.rs");
    std::fs::write(&file, ENDLESS).expect("written");
    let (out, model) = (directory.to_str().expect("UTF-8"), file.to_str().expect("UTF-8"));
    for command in ["report", "stability"] {
        let (output, waited) = reaction(&[command, model, "--out", out]);
        assert_eq!(output.status.code(), Some(130), "{command}: {}", errors(&output));
        assert!(waited < Duration::from_secs(1), "{command}: {waited:?}");
        assert!(errors(&output).contains("interrupted after"), "{}", errors(&output));
    }
    assert!(directory.join("index.html").exists() && directory.join("stability.html").exists());
    std::fs::remove_dir_all(directory).expect("removed");
}
