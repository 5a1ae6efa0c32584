//! What makes no sense is said in one line, with the nearest right name, and code 2.

use crate::program::{errors, run};

#[test]
fn a_slip_is_told_in_a_line_with_what_was_meant() {
    let model = "trestle";
    let slips: &[(&[&str], &str)] = &[
        (&["run", "tresle"], "no model `tresle`; did you mean `trestle`?"),
        (&["explain", "tresle"], "did you mean `trestle`?"),
        (&["modes", "tresle"], "did you mean `trestle`?"),
        (&["precision", "tresle"], "did you mean `trestle`?"),
        (&["stability", "tresle"], "did you mean `trestle`?"),
        (&["stability", "toleranses"], "did you mean `tolerances`?"),
        (&["run", model, "--set", "pp=1"], "no parameter `pp`; did you mean `p`?"),
        (&["run", model, "--start", "alfa=1"], "no coordinate `alfa`; did you mean `alpha`?"),
        (&["run", model, "--start", "alpha=75degs"], "no unit `degs`; did you mean `deg`?"),
        (&["run", model, "--limit", "3 sec"], "no unit `sec`; did you mean `s`?"),
        (&["run", model, "--output", "N(a)"], "did you mean `A`?"),
        (&["run", model, "--output", "alpa'"], "did you mean `alpha`?"),
        (&["run", model, "--until", "alpa = 0"], "did you mean `alpha`?"),
        (&["run", model, "--hold", "a"], "did you mean `A`?"),
        (&["run", model, "--release", "a@1"], "did you mean `A`?"),
        (&["run", model, "--impulse", "c=0,1@0.1"], "did you mean `C`?"),
        (&["run", model, "--method", "tailor"], "no method `tailor`; did you mean `taylor`?"),
        (&["precision", model, "--methods", "radou"], "did you mean `radau`?"),
        (&["run", model, "--unti", "t = 1"], "'--until'"),
        (&["rum"], "'run'"),
    ];
    for (arguments, said) in slips {
        refused(arguments, said);
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let model = "trestle";
    let nonsense: &[(&[&str], &str)] = &[
        (&["run"], "<MODEL>"),
        (&["run", model, "--set", "m=-1"], "negative"),
        (&["run", model, "--set", "l=0"], "not positive"),
        (&["run", model, "--set", "m"], "expected name=value"),
        (&["run", model, "--set", "m=two"], "`two`"),
        (&["run", model, "--start", "y=-1", "--start", "alpha=1"], "support"),
        (&["run", model, "--tol", "2"], "tolerance 2 is not between 0 and 1"),
        (&["run", model, "--limit", "-1"], "time limit -1"),
        (&["run", model, "--every", "0"], "expected a time > 0"),
        (&["run", model, "--every", "1e-9"], "rows"),
        (&["run", model, "--until", "t = 0"], "cannot end a run"),
        (&["run", model, "--json", "--csv", "a.csv"], "cannot be used with"),
        (&["completions", "tcsh"], "tcsh"),
    ];
    for (arguments, said) in nonsense {
        refused(arguments, said);
    }
}

fn refused(arguments: &[&str], said: &str) {
    let output = run(arguments);
    let error = errors(&output);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {error}");
    assert!(error.starts_with("error: ") && error.contains(said), "{arguments:?}: {error}");
    assert_eq!(error.lines().count(), 1, "{arguments:?}: {error}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
}

#[test]
fn a_file_that_cannot_be_written_is_named() {
    let model = "trestle";
    let path = "/nowhere/at/all.csv";
    let writers: [&[&str]; 3] = [
        &["run", model, "--csv", path],
        &[
            "precision",
            model,
            "--measuring",
            "0",
            "--tolerances",
            "1e-6",
            "--methods",
            "taylor",
            "--csv",
            path,
        ],
        &[
            "precision",
            model,
            "--measuring",
            "0",
            "--tolerances",
            "1e-6",
            "--methods",
            "taylor",
            "--svg",
            path,
        ],
    ];
    for arguments in writers {
        let output = run(arguments);
        let error = errors(&output);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {error}");
        assert!(error.contains(path) && error.lines().count() == 1, "{arguments:?}: {error}");
    }
}

/// Only the feet are declared to stand on the floor.
#[test]
fn a_point_behind_a_floor_is_noted_and_the_run_goes_on() {
    let output = run(&["run", "trestle", "--start", "alpha=-1", "--start", "beta=-1", "--limit", "0.1"]);
    let note = errors(&output);
    assert!(output.status.success(), "{note}");
    assert!(note.starts_with("note: C starts ") && note.contains("behind the line of support"), "{note}");
}
