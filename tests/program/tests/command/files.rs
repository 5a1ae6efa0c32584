//! Files are written whole or not at all, whichever command writes them.

use crate::program::{command, errors, run, run_program, temporary_path};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

const MODEL: &str = "trestle";
const SHORT: [&str; 2] = ["--limit", "0.1"];
const MEASURED: [&str; 6] = ["--measuring", "0", "--tolerances", "1e-6", "--methods", "taylor"];
const SWEPT: [&str; 2] = ["--vary=p=1:70:3", "--observe=end"];

/// Everything that writes a file, with the name that it is to have.
fn writers() -> Vec<(Vec<&'static str>, &'static str)> {
    let with = |command: &[&'static str], options: &[&'static str], last: &[&'static str]| {
        [command, options, last].concat()
    };
    vec![
        (with(&["run", MODEL], &SHORT, &["--csv", "out.csv"]), "out.csv"),
        (with(&["plot", MODEL], &SHORT, &["--out", "out.svg"]), "out.svg"),
        (with(&["animate", MODEL], &SHORT, &["--out", "out.html"]), "out.html"),
        (with(&["explain", MODEL], &[], &["--output", "out.txt"]), "out.txt"),
        (with(&["modes", MODEL], &[], &["--svg", "out.svg"]), "out.svg"),
        (with(&["precision", MODEL], &MEASURED, &["--limit", "0.1", "--csv", "out.csv"]), "out.csv"),
        (with(&["precision", MODEL], &MEASURED, &["--limit", "0.1", "--svg", "out.svg"]), "out.svg"),
        (with(&["sweep", MODEL], &SWEPT, &["--limit", "0.1", "--svg", "out.svg"]), "out.svg"),
        (with(&["stability", "--short", "forms"], &[], &["--out", "."]), "stability.html"),
    ]
}

/// An empty folder of a test's own.
fn folder(name: &str) -> PathBuf {
    let folder = temporary_path(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).expect("a folder").flatten().map(|entry| entry.file_name());
    names.map(|name| name.to_string_lossy().into_owned()).collect()
}

/// The program where files may have no bytes, as on a disk that is full.
fn on_a_full_disk(folder: &Path, arguments: &[&str]) -> Output {
    let shell = "trap '' XFSZ; ulimit -f 0; exec \"$0\" \"$@\"";
    let mut command = Command::new("sh");
    command.args(["-c", shell, env!("CARGO_BIN_EXE_trestle")]).args(arguments).current_dir(folder);
    command.output().expect("a shell")
}

#[cfg(unix)]
#[test]
fn on_a_full_disk_nothing_stands_under_the_final_name() {
    let folder = folder("full");
    for (arguments, name) in writers() {
        let output = on_a_full_disk(&folder, &arguments);
        let error = errors(&output);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {error}");
        let lines = error
            .lines()
            .filter(|line| !["warning: ", "note: "].iter().any(|head| line.starts_with(head)))
            .count();
        assert!(error.contains("cannot write ") && lines == 1, "{arguments:?}: {error}");
        assert!(names(&folder).is_empty(), "{arguments:?}: {:?}", names(&folder));
        fs::write(folder.join(name), "before").expect("a file");
        assert_eq!(on_a_full_disk(&folder, &arguments).status.code(), Some(1));
        assert_eq!(fs::read_to_string(folder.join(name)).expect("a file"), "before", "{arguments:?}");
        assert_eq!(names(&folder).len(), 1, "{arguments:?}: {:?}", names(&folder));
        fs::remove_file(folder.join(name)).expect("removed");
    }
    fs::remove_dir(folder).expect("removed");
}

#[cfg(target_os = "linux")]
#[test]
fn devices_stay_and_links_are_followed() {
    let folder = folder("devices");
    for (arguments, name) in writers() {
        // Its page has a name of its own.
        if name == "stability.html" {
            continue;
        }
        let to = |target: &'static str| {
            let last = arguments.len() - 1;
            [&arguments[..last], &[target]].concat()
        };
        let full = command(&to("/dev/full")).current_dir(&folder).output().expect("the program starts");
        assert_eq!(full.status.code(), Some(1), "{arguments:?}: {}", errors(&full));
        assert!(errors(&full).contains("cannot write /dev/full"), "{arguments:?}: {}", errors(&full));
        let piped = command(&to("/dev/stdout")).current_dir(&folder).output().expect("the program starts");
        assert!(piped.status.success() && piped.stdout.len() > 100, "{arguments:?}: {}", errors(&piped));
        std::os::unix::fs::symlink("target", folder.join("link")).expect("a link");
        let linked = command(&to("link")).current_dir(&folder).output().expect("the program starts");
        assert!(linked.status.success(), "{arguments:?}: {}", errors(&linked));
        assert!(fs::symlink_metadata(folder.join("link")).expect("a link").is_symlink(), "{arguments:?}");
        assert!(fs::metadata(folder.join("target")).expect("a file").len() > 100, "{arguments:?}");
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder");
    }
    fs::remove_dir(folder).expect("removed");
}

/// What is printed and what is written share the file that the standard output goes to.
#[cfg(target_os = "linux")]
#[test]
fn a_table_on_the_standard_output_stands_beside_what_is_printed() {
    let folder = folder("stdout");
    let file = fs::File::create(folder.join("both")).expect("a file");
    let mut command = command(&["run", MODEL, "--limit", "0.1", "--csv", "/dev/stdout"]);
    assert!(command.stdout(file).status().expect("the program starts").success());
    let both = fs::read_to_string(folder.join("both")).expect("both");
    assert!(both.starts_with("t [s],alpha [rad],beta [rad],") && both.contains("\nstart at t = 0"), "{both}");
    fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn a_report_that_cannot_be_written_leaves_its_folder_as_it_was() {
    let folder = folder("report");
    let output = on_a_full_disk(&folder, &["report", MODEL, "--out", "."]);
    assert_eq!(output.status.code(), Some(1), "{}", errors(&output));
    assert!(names(&folder).is_empty(), "{:?}", names(&folder));
    fs::remove_dir(folder).expect("removed");
}

/// The code of the error is all that is left to tell.
#[cfg(target_os = "linux")]
#[test]
fn an_error_that_cannot_be_reported_keeps_its_code() {
    let full = || Stdio::from(fs::File::options().write(true).open("/dev/full").expect("a device"));
    let code = |arguments: &[&str]| {
        command(arguments).stdout(Stdio::null()).stderr(full()).status().expect("the program starts").code()
    };
    assert_eq!(code(&["run", "nosuch"]), Some(2));
    assert_eq!(code(&["run"]), Some(2));
    assert_eq!(code(&["run", MODEL, "--csv", "/dev/null/at/all.csv"]), Some(1));
    assert_eq!(code(&["run", MODEL, "--start", "alpha=-1", "--start", "beta=-1", "--limit", "0.1"]), Some(0));
    let mistakes = temporary_path("mistakes.rs");
    fs::write(&mistakes, "#[derive(BarSystem)] struct None { }").expect("a file");
    assert_eq!(code(&["explain", mistakes.to_str().expect("UTF-8")]), Some(1));
    fs::remove_file(mistakes).expect("removed");
    assert!(!run_program(&["list"]).is_empty() && run(&["list"]).status.success());
}

/// Two sweeps at once: one has the journal, the other is refused, and the table is as if it had
/// been alone.
#[test]
fn a_second_sweep_on_a_journal_is_refused() {
    let folder = folder("two-sweeps");
    let arguments =
        ["sweep", MODEL, "--vary=p=1:70:500", "--observe=end y(C)", "--csv=out.csv", "--threads=1"];
    let sweep = || {
        let mut command = command(&arguments);
        command.current_dir(&folder).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    };
    let mut first = sweep().spawn().expect("the program starts");
    let journal = folder.join("out.csv.journal");
    while fs::read(&journal).map_or(0, |bytes| bytes.len()) < 3000 {
        assert!(first.try_wait().expect("a child").is_none(), "it ended before the other began");
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    let second = sweep().output().expect("the program starts");
    let error = errors(&second);
    assert_eq!(second.status.code(), Some(2), "{error}");
    assert!(error.contains("out.csv.journal is the journal of a sweep that is running"), "{error}");
    assert!(error.lines().count() == 1 && first.wait().expect("a child").success(), "{error}");
    let table = fs::read_to_string(folder.join("out.csv")).expect("a table");
    assert!(sweep().output().expect("the program starts").status.success());
    assert_eq!(fs::read_to_string(folder.join("out.csv")).expect("a table"), table);
    let alone = [&arguments[..4], &["--csv=alone.csv"]].concat();
    assert!(command(&alone).current_dir(&folder).status().expect("the program starts").success());
    assert_eq!(fs::read_to_string(folder.join("alone.csv")).expect("a table"), table);
    // The tables have what the journals had.
    assert!(names(&folder).iter().all(|name| name.ends_with(".csv")), "{:?}", names(&folder));
    fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn folders_are_made_and_what_was_written_is_reported() {
    let folder = folder("made");
    for (arguments, name) in writers().into_iter().filter(|(_, name)| *name != "stability.html") {
        let path = format!("deep/deeper/{name}");
        let last = arguments.len() - 1;
        let arguments = [&arguments[..last], &[path.as_str()]].concat();
        let output = command(&arguments).current_dir(&folder).output().expect("the program starts");
        assert!(output.status.success(), "{arguments:?}: {}", errors(&output));
        assert!(fs::metadata(folder.join(&path)).expect("a file").len() > 100, "{arguments:?}");
        let told = [String::from_utf8_lossy(&output.stdout).into_owned(), errors(&output)].concat();
        assert!(told.contains(&path), "{arguments:?}: {told}");
        fs::remove_dir_all(folder.join("deep")).expect("removed");
    }
    fs::remove_dir_all(folder).expect("removed");
}

/// A table for another program, with nothing beside it.
#[test]
fn a_dash_is_the_standard_output() {
    let folder = folder("dash");
    let swept = [&["sweep", MODEL, "--limit", "0.1"], &SWEPT[..], &["--csv", "-"]].concat();
    let run = [&["run", MODEL], &SHORT[..], &["--csv", "-"]].concat();
    for (arguments, head, beside) in
        [(run, "t [s],alpha [rad],", "start at t = 0"), (swept, "member,p,", "3 members")]
    {
        let output = command(&arguments).current_dir(&folder).output().expect("the program starts");
        let table = String::from_utf8(output.stdout.clone()).expect("UTF-8");
        let columns = |line: &str| line.split(',').count();
        assert!(output.status.success() && table.starts_with(head), "{table}");
        assert!(table.lines().all(|line| columns(line) == columns(table.lines().next().expect("a head"))));
        assert!(errors(&output).contains(beside), "{}", errors(&output));
    }
    assert!(names(&folder).is_empty(), "{:?}", names(&folder));
    fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn pictures_are_svg_and_said_to_be() {
    for arguments in [&["plot", MODEL, "--out"][..], &["modes", MODEL, "--svg"]] {
        let output = run(&[arguments, &["motion.png"]].concat());
        assert_eq!(output.status.code(), Some(2), "{}", errors(&output));
        assert!(errors(&output).contains("name the file motion.svg"), "{}", errors(&output));
    }
}

/// A run of any length is not computed for a file that cannot be written.
#[test]
fn a_file_is_refused_before_the_run() {
    let begun = std::time::Instant::now();
    let endless = ["run", MODEL, "--until", "t = 1e7", "--limit", "1e8", "--csv", "/dev/null/a.csv"];
    assert_eq!(run(&endless).status.code(), Some(1));
    assert!(begun.elapsed() < std::time::Duration::from_secs(5));
}

#[test]
fn forms_that_are_not_written_are_refused_before_anything_is_computed() {
    let sweep = [&["sweep", MODEL], &SWEPT[..]].concat();
    let cases: [(&[&str], &str, &str, &str); 17] = [
        (&["animate", MODEL], "--out", "a.gif", "as HTML or SVG, not as GIF; name the file a.html or a.svg"),
        (&["animate", MODEL], "--out", "a.mp4", "not as MP4"),
        (&["animate", MODEL], "--out", "a.xyz", "not as XYZ"),
        (&["plot", MODEL], "--out", "a.pdf", "as SVG, not as PDF; name the file a.svg"),
        (&["plot", MODEL], "--out", "a.html", "not as HTML"),
        (&["modes", MODEL], "--svg", "a.png", "as SVG, not as PNG"),
        (&["linearise", MODEL], "--svg", "a.png", "as SVG, not as PNG"),
        (&["precision", MODEL], "--csv", "a.png", "as CSV, not as PNG; name the file a.csv"),
        (&["precision", MODEL], "--svg", "a.webp", "not as WEBP"),
        (&["run", MODEL], "--csv", "a.svg", "as CSV, not as SVG"),
        (&sweep, "--csv", "a.json", "as CSV, not as JSON"),
        (&sweep, "--svg", "a.gif", "as SVG, not as GIF"),
        (&sweep, "--out", "a.gif", "a folder is written, not a file; name it a"),
        (&["report", MODEL], "--out", "a.pdf", "a folder is written"),
        (&["stability", MODEL], "--out", "a.html", "a folder is written"),
        (&["explain", MODEL], "--output", "a.pdf", "as text or LaTeX or HTML, not as PDF"),
        (&["export", MODEL], "--sympy", "a.txt", "as Python, not as TXT; name the file a.py"),
    ];
    for (command, option, name, said) in cases {
        let output = run(&[command, &[option, name]].concat());
        assert_eq!(output.status.code(), Some(2), "{command:?} {name}");
        assert!(errors(&output).contains(said), "{command:?} {name}: {}", errors(&output));
        assert!(!std::env::temp_dir().join(name).exists(), "{name}");
    }
}

/// A format that is given by its name may not contradict the file's.
#[test]
fn equations_are_written_as_their_file_is_named() {
    let path = temporary_path("equations.tex");
    let file = path.to_str().expect("UTF-8");
    run_program(&["explain", MODEL, "--output", file]);
    assert!(std::fs::read_to_string(&path).expect("written").contains("\\documentclass"));
    std::fs::remove_file(&path).expect("removed");
    let refused = run(&["explain", MODEL, "--format", "html", "--output", file]);
    assert!(errors(&refused).contains("as HTML, not as TEX"), "{}", errors(&refused));
    assert!(!path.exists());
}
