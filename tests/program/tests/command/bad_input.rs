//! What makes no sense is said in one line, with the nearest right name, and code 2.

use crate::program::{errors, run};

#[test]
fn a_slip_is_reported_in_a_line_with_what_was_meant() {
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
fn impossible_input_is_refused() {
    let model = "trestle";
    let nonsense: &[(&[&str], &str)] = &[
        (&["run"], "<MODEL|FILE.rs>"),
        (&["run", model, "--set", "m=-1"], "negative"),
        (&["run", model, "--set", "l=0"], "must be positive"),
        (&["run", model, "--set", "m"], "expected name=value"),
        (&["run", model, "--set", "m=two"], "`two`"),
        (&["run", model, "--start", "y=-1", "--start", "alpha=1"], "support"),
        (&["run", model, "--tol", "2"], "tolerance 2 is not between 0 and 1"),
        (&["run", model, "--limit", "-1"], "time limit -1"),
        (&["run", model, "--every", "0"], "expected a time > 0"),
        (&["run", model, "--every", "1e-9"], "rows"),
        (&["run", model, "--until", "t = 0"], "cannot end a run"),
        (&["run", model, "--json", "--csv", "a.csv"], "cannot be used with"),
        (&["run", model, "--set", "m=1", "--set", "m=2"], "--set: `m` is given twice"),
        (&["run", model, "--start", "alpha=1", "--start", "alpha=1"], "--start: `alpha` is given twice"),
        (&["run", model, "--start", "alpha=1e17"], "alpha = 1e17: numbers there are 2.2e1 rad apart"),
        (&["run", model, "--start", "alpha=1e200*1e200"], "alpha"),
        (&["run", model, "--start", "alpha=3mm"], "--start alpha: measured in rad, not in m"),
        (&["run", model, "--start", "alpha'=3rad"], "--start alpha': measured in rad/s, not in rad"),
        (&["run", model, "--set", "l=2kg"], "--set l: measured in m, not in kg"),
        (&["run", model, "--set", "g=9.81 N"], "--set g: measured in m/s², not in N"),
        (&["run", model, "--limit", "3 mm"], "`3 mm` is measured in m, not in s"),
        (&["run", model, "--at", "-1"], "--at -1: the run begins at t = 0"),
        (&["run", model, "--tol", "1e-300"], "the least is 1e-18"),
        (&["run", model, "--tol", "1e-9 m"], "measured in m"),
        (&["plot", model, "--width", "12"], "`12` is no whole number from 240 to 10000"),
        (&["plot", model, "--width", "wide"], "`wide` is no number"),
        (&["plot", model, "--positions", "3000000000"], "`3000000000` is no whole number from 1 to 1000"),
        (&["plot", model, "--also", "alpha=1mm"], "--start alpha: measured in rad, not in m"),
        (&["precision", model, "--tolerances=1e-6,-1"], "tolerance -1 is not between 0 and 1"),
        (&["precision", model, "--tolerances", "0"], "tolerance 0 is not between 0 and 1"),
        (&["precision", model, "--tolerances", "NaN"], "`NaN` is no number"),
        (&["precision", model, "--tolerances", "1/0"], "tolerance inf is not between 0 and 1"),
        (&["precision", model, "--tolerances", "1e-300"], "the least is 1e-18"),
        (&["precision", model, "--measuring", "18446744073709551615"], "is no whole number"),
        (&["completions", "tcsh"], "tcsh"),
    ];
    for (arguments, said) in nonsense {
        refused(arguments, said);
    }
}

const HUGE: [&str; 4] = ["1000000000", "99999999999", "18446744073709551615", "18446744073709551616"];

#[test]
fn excessive_input_is_refused_with_its_limit() {
    let observe = "--observe=end";
    for huge in HUGE {
        let range = format!("p=1:2:{huge}");
        let told = if huge.ends_with("616") { "is no count" } else { "4000000 members are the most" };
        refused(&["sweep", "trestle", "--vary", &range, observe], told);
        refused(&["sweep", "trestle", "--bisect", &range, observe], told);
        for option in ["--random", "--sobol"] {
            let told = format!("`{huge}` is no whole number from 1 to 4000000");
            refused(&["sweep", "trestle", "--vary", "p=1:2", observe, option, huge], &told);
        }
        let told = format!("`{huge}` is no whole number from 1 to 1024");
        refused(&["sweep", "trestle", "--vary", "p=1:2:3", observe, "--threads", huge], &told);
    }
    let grid = ["sweep", "trestle", "--vary=p=1:2:4000000", "--vary=m=1:2:2", observe];
    refused(&grid, "a grid of 8000000 points: 4000000 are the most");
}

#[test]
fn long_or_deep_input_is_refused() {
    let sum = |terms: usize| vec!["alpha"; terms].join("+");
    for (text, told) in [
        (sum(1500) + "=9", "more than 1000 operators, at column "),
        (sum(20_000), "an expression of 119999 characters: at most 10000 are allowed"),
        ("(".repeat(3000), "nested too deeply at column 65"),
        ("-".repeat(3000), "nested too deeply at column 65"),
        ("sin(".repeat(2000), "nested too deeply"),
    ] {
        for option in ["--output", "--until"] {
            refused(&["run", "trestle", &format!("{option}={text}")], told);
        }
    }
    refused(&["run", "trestle", "--set", &format!("m={}", "1+".repeat(60_000))], "at most 10000 are allowed");
    // As wide as a column becomes, and as deep as a sum may be.
    let wide = format!("{}alpha", " ".repeat(9000));
    let output =
        run(&["run", "trestle", "--limit", "0.1", "--output", &wide, "--until", &(sum(1000) + "=9000")]);
    assert!(output.status.success(), "{}", errors(&output));
}

#[test]
fn a_time_that_the_run_does_not_reach_is_an_error_behind_the_table() {
    let output = run(&["run", "trestle", "--limit", "0.1", "--at", "0.05", "--at", "3", "--output", "E"]);
    assert_eq!(output.status.code(), Some(1));
    let told = "note: at t = 0.1000: the run ends here, and `y(C) = 0` was not met\n\
                error: t = 3 is not within the run, which ended at t = 0.1\n";
    assert_eq!(errors(&output), told);
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(table.lines().count() == 4 && table.contains("0.05000000"), "{table}");
}

#[test]
fn rows_of_another_tool_that_are_none_are_refused_before_anything_runs() {
    let path = crate::program::temporary_path("peers.csv");
    for (text, told) in [
        (
            "scene,tolerance,error,end_error,microseconds\ntrestle,1e-6,1e-320,1e300,10\n",
            "row 1: error 1e-320",
        ),
        ("scene,tolerance,error,end_error,microseconds\n", "has no rows"),
    ] {
        std::fs::write(&path, text).expect("a file");
        refused(&["precision", "trestle", "--peers", path.to_str().expect("UTF-8")], told);
    }
    #[cfg(target_os = "linux")]
    assert!(
        errors(&run(&["precision", "trestle", "--peers", "/dev/zero"])).contains("more than 67108864 bytes")
    );
    std::fs::write(&path, [0xff, 0, 0x80]).expect("a file");
    assert_eq!(
        run(&["precision", "trestle", "--peers", path.to_str().expect("UTF-8")]).status.code(),
        Some(2)
    );
    std::fs::remove_file(path).expect("removed");
}

#[test]
fn values_in_units_of_what_they_measure_are_taken() {
    let given = ["--set", "l=200 cm", "--set", "g=981 cm/s^2", "--set", "m=6000g", "--limit", "100 ms"];
    let start = ["--start", "alpha=75deg", "--start", "beta=1.3 rad", "--start", "y'=0 m/s"];
    let output = run(&[&["run", "trestle"][..], &given, &start, &["--at", "50ms"]].concat());
    assert!(output.status.success(), "{}", errors(&output));
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
    let path = "/dev/null/at/all";
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
