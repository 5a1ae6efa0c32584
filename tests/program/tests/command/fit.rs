//! Fits to tables and event times.

use crate::program::{errors, run, run_program, temporary_path};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A ball that falls on a floor and bounces.
const BALL: &str = "
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[slider(P = vertical(0))]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(y = y(P))]
#[run(start = \"y = 1\", until = \"t = 0.2\", limit = 0.3)]
struct Ball {
    #[value = 1.0]
    m: f64,
    #[value = 0.5]
    e: f64,
    #[value = 12.0]
    g: f64,
}";

/// A table beside a model, each of one test.
struct Files {
    model: PathBuf,
    table: PathBuf,
}

impl Files {
    fn new(name: &str, table: &str) -> Self {
        let files = Self {
            model: temporary_path(&format!("{name}.rs")),
            table: temporary_path(&format!("{name}.csv")),
        };
        std::fs::write(&files.model, BALL).expect("a file");
        std::fs::write(&files.table, table).expect("a file");
        files
    }

    fn command<'a>(&'a self, more: &[&'a str]) -> Vec<&'a str> {
        let path = |path: &'a Path| path.to_str().expect("a name");
        [&["fit", path(&self.model), "--data", path(&self.table)], more].concat()
    }

    fn json(&self, more: &[&str]) -> Value {
        serde_json::from_str(&run_program(&[&self.command(more)[..], &["--json"]].concat())).expect("JSON")
    }

    /// The error, of one line with this exit code.
    fn refused(&self, code: i32, more: &[&str]) -> String {
        let output = run(&self.command(more));
        let error = errors(&output);
        assert_eq!((output.status.code(), error.lines().count()), (Some(code), 1), "{more:?}: {error}");
        error
    }
}

fn value(found: &Value, name: &str) -> f64 {
    found["estimates"][name]["value"].as_f64().expect("a number")
}

/// Heights and speeds of a ball with e = 0.7 and g = 10, dropped from y = 0.8: it strikes at t =
/// 0.4 with the speed 4.
fn heights() -> String {
    let row = |i: u32| {
        let t = 0.1 * f64::from(i) + 0.05;
        let (y, rate) = match t < 0.4 {
            true => (0.8 - 5.0 * t * t, -10.0 * t),
            false => (2.8 * (t - 0.4) - 5.0 * (t - 0.4).powi(2), 2.8 - 10.0 * (t - 0.4)),
        };
        // The model's default run is shorter; some cells are empty.
        let rate = if i.is_multiple_of(3) { String::new() } else { rate.to_string() };
        format!("{t},{y},0.01,{rate},of the camera\n")
    };
    format!("t,y,y ±,y',remark\n{}", (0..8).map(row).collect::<String>())
}

#[test]
fn parameters_and_starts_are_found_from_a_table() {
    let files = Files::new("heights", &heights());
    let vary = ["--vary", "e", "--vary", "g", "--vary", "y"];
    let found = files.json(&[&vary[..], &["--of", "y"]].concat());
    for (name, exact) in [("e", 0.7), ("g", 10.0), ("y", 0.8)] {
        assert!((value(&found, name) - exact).abs() < 1e-8, "{found}");
    }
    assert_eq!((found["converged"].as_bool(), found["freedom"].as_u64()), (Some(true), Some(5)));
    let both = files.json(&[&vary[..], &["--of", "y", "--of", "y'", "--sd", "y'=0.1 m/s"]].concat());
    assert!((value(&both, "e") - 0.7).abs() < 1e-8, "{both}");
    assert_eq!((both["residuals"].as_array().map(Vec::len), both["skipped"].as_u64()), (Some(13), Some(3)));
    // The impact is at 0.4; its time is one more value.
    let timed = files.json(&[&vary[..], &["--of", "y", "--event", "first impact=0.4 ± 1 ms"]].concat());
    assert!((value(&timed, "g") - 10.0).abs() < 1e-8 && timed["freedom"] == 6, "{timed}");
    let typed = files.json(&[&vary[..], &["--of", "y", "--event", "first impact=0.4 +- 0.001"]].concat());
    assert_eq!(typed, timed);
    let text = run_program(&files.command(&["--vary", "e", "--vary", "y", "--set", "g=10", "--of", "y"]));
    for part in ["standard error", "correlation", "8 values", "6 degrees of freedom", "converged after"] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

/// The same measurements in other units, and the table that a run writes.
#[test]
fn heads_of_tables_have_units() {
    let vary = ["--vary", "e", "--vary", "g", "--vary", "y", "--of", "y"];
    let plain = Files::new("plain", &heights()).json(&vary);
    let in_units = |head: &str| heights().replacen("t,y,y ±,y',", head, 1);
    let named = Files::new("named", &in_units("t [s],y [m],y [m] ±,y' [m/s],")).json(&vary);
    assert_eq!(named["estimates"], plain["estimates"]);
    let thousandfold = |row: &str| {
        let cells = row.split(',').take(3).map(|cell| 1e3 * cell.parse::<f64>().expect("a number"));
        cells.map(|cell| cell.to_string()).collect::<Vec<_>>().join(",") + "\n"
    };
    let rows: String = heights().lines().skip(1).map(thousandfold).collect();
    for head in ["t [ms],y [mm],y [mm] ±\n", "t [ms],y [mm],y ±\n"] {
        let small = Files::new("small", &(head.to_owned() + &rows)).json(&vary);
        for name in ["e", "g", "y"] {
            assert!((value(&small, name) - value(&plain, name)).abs() < 1e-8, "{head}: {small}");
        }
    }
    let files = Files::new("written", "");
    let written = files.table.to_str().expect("a name").to_owned();
    let until = ["--until", "t = 1", "--limit", "1", "--every", "0.1"];
    run_program(&[&["run", files.model.to_str().expect("a name"), "--csv", &written], &until[..]].concat());
    let head = std::fs::read_to_string(&written).expect("a table");
    assert!(head.starts_with("t [s],") && head.contains(",y [m],"), "{head}");
    let found = files.json(&["--vary", "e", "--of", "y"]);
    assert!((value(&found, "e") - 0.5).abs() < 1e-6, "{found}");
}

/// t₁ = √(2h/g), t₂ = t₁ (1 + 2e).
#[test]
fn event_times_alone_give_as_many_values() {
    let files = Files::new("times", "");
    let name = files.model.to_str().expect("a name");
    let command = ["fit", name, "--vary", "g", "--vary", "e", "--limit", "3", "--until", "t = 3"];
    let events = ["--event", "first impact=0.4", "--event", "t of 2nd impact=0.96"];
    let text = run_program(&[&command[..], &events].concat());
    assert!(text.contains("there are no degrees of freedom left") && !text.contains("correlation"), "{text}");
    let found: Value =
        serde_json::from_str(&run_program(&[&command[..], &events, &["--json"]].concat())).expect("JSON");
    assert!((value(&found, "g") - 12.5).abs() < 1e-9 && (value(&found, "e") - 0.7).abs() < 1e-10, "{found}");
    assert!(found["estimates"]["g"]["interval"].is_null(), "{found}");
    // No ball takes 5 s where runs end after 3 s.
    let output =
        run(&["fit", name, "--vary", "g", "--limit", "3", "--until", "t=3", "--event", "first impact=5"]);
    let error = errors(&output);
    assert_eq!(output.status.code(), Some(1), "{error}");
    assert!(error.contains("has not converged") && error.contains("no first impact"), "{error}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("not converged after"));
}

#[test]
fn tables_that_are_none_are_refused_in_a_line() {
    let vary = ["--vary", "g"];
    for (name, table, said) in [
        ("no_time", "y\n1\n", "there is no column `t`"),
        ("nothing", "", "is empty"),
        ("semicolons", "t;y\n0;1\n", "there is no column `t` among `t;y`, separated by commas"),
        (
            "stray",
            "t,y,x ±\n0.1,1,1\n",
            "column `x ±`: there is no column with values for these standard deviations",
        ),
        ("only_time", "t\n1\n", "there is no column beside `t`"),
        ("empty", "t,y\n", "has no values"),
        ("gaps", "t,y\n0.1,\n0.2,\n", "has no values"),
        ("unknown", "t,yy\n0.1,1\n", "column `yy`: no name `yy`"),
        ("twice", "t,y,y\n0.1,1,1\n", "the column `y` is there twice"),
        ("unit", "t,y [s]\n0.1,1\n", "column `y`: measured in m, not in s"),
        ("no_unit", "t,y [mm\n0.1,1\n", "column `y [mm`"),
        ("same", "t,y,y [mm]\n0.1,1,1\n", "the column `y` is there twice"),
        ("word", "t,y\n0.1,one\n", ", line 2: y: `one` is no number"),
        ("nan", "t,y\n0.1,1\n0.2,NaN\n", ", line 3: y: NaN is not finite"),
        ("infinite", "t,y\ninf,1\n", ", line 2: t: inf is not finite"),
        ("no_t", "t,y\n,1\n", ", line 2: t: `` is no number"),
        ("back", "t,y\n0.2,1\n0.1,1\n", ", line 3: t = 0.1 does not come after t = 0.2"),
        ("thrice", "t,y\n0.2,1\n0.2,1\n0.2,1\n", ", line 4: t = 0.2 is there three times"),
        ("before", "t,y\n-0.1,1\n", ", line 2: t = -0.1 is before the start"),
        ("narrow", "t,y\n0.1\n", ", line 2: 1 cells, but the header has 2"),
        ("wide", "t,y\n0.1,1,2\n", ", line 2: 3 cells, but the header has 2"),
        ("deviation", "t,y,y ±\n0.1,1,0\n", ", line 2: y ±: a standard deviation is a number > 0"),
        ("several", "t,y,y'\n0.1,1,0\n", "--sd COLUMN=VALUE"),
    ] {
        let error = Files::new(name, table).refused(2, &vary);
        assert!(error.contains(said), "{name}: {error}");
    }
}

#[test]
fn requests_that_make_no_sense_are_refused_in_a_line() {
    let files = Files::new("requests", "t,y\n0.1,0.95\n0.2,0.8\n");
    let usage: &[(&[&str], &str)] = &[
        (&["--vary", "h"], "--vary h: neither a parameter nor given at the start"),
        (&["--vary", "g", "--vary", "g"], "--vary: `g` is given twice"),
        (&["--vary", "g", "--limit", "0.15"], "line 3 of the table: t = 0.2 is after the limit 0.15"),
        (&["--vary", "g", "--of", "x"], "no column `x`; there are y"),
        (&["--vary", "g", "--of", "y", "--of", "y"], "--of y is given twice"),
        (&["--vary", "g", "--sd", "y=1", "--sd", "y=2"], "--sd y is given twice"),
        (&["--vary", "g", "--sd", "x=1"], "--sd x: no such column is fitted; there are y"),
        (&["--vary", "g", "--sd", "y=0"], "--sd y=0: a standard deviation is a number > 0"),
        (&["--vary", "g", "--event", "first impact"], "expected WHAT=VALUE"),
        (&["--vary", "g", "--event", "first impakt=1"], "did you mean `impact`?"),
        (&["--vary", "g", "--event", "count impact=1"], "expected an event"),
        (&["--vary", "g", "--event", "first impact=0.4+-0"], "a standard deviation is a number > 0"),
        (&["--vary", "g", "--event", "first impact=-1±0.1"], "it is before the start at t = 0"),
        (&["--vary", "g", "--event", "first impact=0.4"], "has no standard deviation"),
        (&["--vary", "g", "--vary", "e", "--vary", "y"], "2 measured values are too few for 3 variables"),
    ];
    for (more, said) in usage {
        let error = files.refused(2, more);
        assert!(error.contains(said), "{more:?}: {error}");
    }
    let failed: &[(&[&str], &str)] = &[
        (&["--vary", "m"], "the data do not determine m: nothing measured depends on it"),
        // No impact is within the data.
        (&["--vary", "g", "--vary", "e"], "the data do not determine e"),
        (&["--vary", "g", "--until", "y = 0.9"], "the run has no y at t = 0.2: it ends with `stop"),
    ];
    for (more, said) in failed {
        let error = files.refused(1, more);
        assert!(error.contains(said), "{more:?}: {error}");
    }
    assert!(errors(&run(&["fit", "trestle", "--vary", "m"])).contains("--data"));
    let missing = run(&["fit", "trestle", "--vary", "m", "--data", "/nowhere/data.csv"]);
    assert!(errors(&missing).contains("cannot read /nowhere/data.csv"));
}
