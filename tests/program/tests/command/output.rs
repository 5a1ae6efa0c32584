//! What a run tells: events, outputs, tables.

use crate::program::{errors, run, run_program, temporary_path};
use serde_json::Value;

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&run_program(arguments)).expect("JSON")
}

#[test]
fn the_models_are_listed() {
    let text = run_program(&["list"]);
    assert!(text.starts_with("trestle            A folding trestle"), "{text}");
    assert!(text.contains(
        "parameters m = 6, p = 70, l = 2, g = 9.81; coordinates alpha, beta, x, y; supports A | B"
    ));
    let models = json(&["list", "--json"]);
    assert_eq!(models[0]["name"], "trestle");
    assert_eq!(models[0]["parameters"]["p"], 70.0);
    assert_eq!(models[0]["supports"], serde_json::json!(["A", "B"]));
}

#[test]
fn equations_and_modes_are_reported() {
    assert!(run_program(&["explain", "trestle"]).contains("T = "));
    assert!(run_program(&["modes", "trestle"]).contains("on A, B"));
}

/// Half the weight bears on each foot of a ladder that is as it stands.
#[test]
fn outputs_are_reported_at_events_and_times() {
    let run = ["run", "trestle", "--until", "t = 0.5", "--output", "N(A)", "--output", "y(C)/l"];
    let table = run_program(&[&run[..], &["--at", "0.3", "--every", "0.25s"]].concat());
    let lines: Vec<Vec<&str>> = table.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(lines[0], ["t", "event", "N(A)", "y(C)/l"]);
    let column = |k: usize| lines[1..].iter().map(move |line| line[k]).collect::<Vec<_>>();
    assert_eq!(column(0), ["0", "0.2500000", "0.3000000", "0.5000000"]);
    assert_eq!((lines[1][1], lines[4][1]), ("start", "stop"));
    // √15/4 of the legs' length.
    let height: f64 = lines[1][3].parse().expect("a number");
    assert!((height - 15f64.sqrt() / 4.0).abs() < 1e-7, "{height}");
    let told = json(&[&run[..], &["--at", "0.3", "--json"]].concat());
    assert_eq!(told["samples"][0]["t"], 0.3);
    assert!(told["events"][0]["outputs"]["N(A)"].as_f64().is_some_and(|force| force > 0.0));
}

/// The trestle's apex falls straight down: at the end x is rounding of nothing, and zero.
#[test]
fn numbers_that_are_rounding_are_zero_in_json_too() {
    let told = json(&["run", "trestle", "--until", "t = 0.5", "--json"]);
    let mut seen = 0;
    for event in told["events"].as_array().expect("events").iter().chain([&told]) {
        let parts = ["state", "final_state", "reactions", "impulses"];
        for value in parts.iter().filter_map(|part| event[part].as_object()).flat_map(|part| part.values()) {
            let value = value.as_f64().expect("a number");
            assert!(value == 0.0 || value.abs() > 1e-15, "{value:e}");
            seen += 1;
        }
    }
    assert!(seen > 10);
}

#[test]
fn a_table_has_the_outputs_and_times_asked_for() {
    let file = temporary_path("outputs.csv");
    let path = file.to_str().expect("UTF-8");
    run_program(&[
        "run", "trestle", "--until", "t = 0.5", "--every", "0.1", "--output", "E/p", "--csv", path,
    ]);
    let written = std::fs::read_to_string(&file).expect("a table");
    std::fs::remove_file(&file).expect("removed");
    let mut lines = written.lines();
    assert!(
        lines.next().is_some_and(
            |head| head.starts_with("t [s],alpha [rad],") && head.ends_with(",E [J],E/p [m² s⁻²]")
        ),
        "{written}"
    );
    let times: Vec<f64> = lines.filter_map(|line| line.split(',').next()?.parse().ok()).collect();
    assert_eq!(times.len(), 6, "{times:?}");
    assert!((times[3] - 0.3).abs() < 1e-15);
}

/// A ball that falls by 1 under g = 2 arrives with 2 at t = 1, and leaves with 1.
const BALL: &str = "/// A ball.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[run(start = \"x = 0, y = 1\", limit = 1.5)]
struct Ball { #[value(1)] m: f64, #[value(0.5)] e: f64, #[value(2)] g: f64 }";

/// Files and JSON have two rows at an impact, before it and after it.
#[test]
fn both_sides_of_an_impact_are_written() {
    let [model, file] = ["ball.rs", "ball.csv"].map(temporary_path);
    std::fs::write(&model, BALL).expect("a file");
    let [path, table] = [&model, &file].map(|path| path.to_str().expect("UTF-8"));
    for asked in [&["run", path, "--csv", table][..], &["run", path, "--every", "0.5", "--csv", table]] {
        // D is known only at the end of the run: other rows, the same two.
        for more in [&[][..], &["--output", "D"]] {
            run_program(&[asked, more].concat());
            let written = std::fs::read_to_string(&file).expect("a table");
            let rows: Vec<Vec<f64>> = written
                .lines()
                .skip(1)
                .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
                .collect();
            let at = rows.iter().position(|row| (row[0] - 1.0).abs() < 1e-12).expect("the impact");
            let (before, after) = (&rows[at], &rows[at + 1]);
            assert_eq!(before[0], after[0], "{written}");
            assert!((before[4] + 2.0).abs() < 1e-9 && (after[4] - 1.0).abs() < 1e-9, "{written}");
            assert!(rows[at + 2][0] > after[0], "{written}");
        }
    }
    let run = json(&["run", path, "--json", "--output", "y'", "--at", "0.5", "--at", "1.2"]);
    let impact = &run["events"][1];
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    assert!((number(&impact["state"]["y'"]) - 1.0).abs() < 1e-9, "{impact}");
    assert!((number(&impact["before"]["state"]["y'"]) + 2.0).abs() < 1e-9, "{impact}");
    assert!((number(&impact["before"]["outputs"]["y'"]) + 2.0).abs() < 1e-9, "{impact}");
    let [energy, left] = [&impact["before"]["energy"]["T"], &impact["energy"]["T"]].map(number);
    assert!((energy - 2.0).abs() < 1e-9 && (left - 0.5).abs() < 1e-9, "{impact}");
    assert!(
        run["events"][0].get("before").is_none() && run["samples"].as_array().is_some_and(|s| s.len() == 2)
    );
    let printed = run_program(&["run", path, "--output", "y'"]);
    let rows: Vec<Vec<&str>> = printed.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(rows[2], ["1.000000", "before", "-2.000000"], "{printed}");
    assert_eq!(rows[3], ["1.000000", "P", "impact", "1.000000"], "{printed}");
    // One at the start has a side before it too.
    let run = json(&["run", path, "--json", "--start", "y=0", "--start", "y'=-1", "--output", "y'"]);
    let outputs = [&run["events"][0]["outputs"], &run["events"][1]["outputs"]];
    assert_eq!(outputs.map(|outputs| number(&outputs["y'"])), [-1.0, 0.5], "{run}");
    for file in [model, file] {
        std::fs::remove_file(file).expect("removed");
    }
}

/// States are taken as the run goes on; the table is the same where an audit keeps the motion.
#[test]
fn a_table_is_the_same_whether_the_motion_is_kept() {
    let times = [
        "run", "trestle", "--until", "t = 0.5", "--every", "0.1", "--at", "0.05", "--at", "0.5", "--at",
        "0.3",
    ];
    let whole = ["run", "trestle", "--limit", "3", "--every", "0.01"];
    let table = run_program(&times);
    // The load stays in the middle, which is no column.
    assert_eq!((table.lines().count(), table.lines().last()), (10, Some("in every row x = 0, x' = 0")));
    assert!(!table.lines().next().expect("a head").contains('x'), "{table}");
    let asked_for = run_program(&[&times[..], &["--output", "x"]].concat());
    assert!(!asked_for.contains("in every row"), "{asked_for}");
    for (asked, rows) in [(&times[..], 10), (&whole[..], 50)] {
        let (table, kept) = (run_program(asked), run_program(&[asked, &["--audit"]].concat()));
        assert!(table.lines().count() >= rows && kept.starts_with(&table), "{table}{kept}");
    }
}

/// The rows of every multiple are in the file alone.
#[test]
fn what_a_file_has_is_not_printed_too() {
    let file = temporary_path("filed.csv");
    let asked = ["run", "trestle", "--until", "t = 0.5", "--every", "0.1", "--at", "0.05"];
    let printed = run_program(&[&asked[..], &["--csv", file.to_str().expect("UTF-8")]].concat());
    let written = std::fs::read_to_string(&file).expect("a file");
    std::fs::remove_file(&file).expect("removed");
    let times = |text: &str, by: &[char]| -> Vec<f64> {
        text.lines().filter_map(|line| line.trim().split(by).next()?.parse().ok()).collect()
    };
    assert_eq!(times(&printed, &[' ']), [0.0, 0.05, 0.5]);
    let (filed, all) = (times(&written, &[',']), times(&run_program(&asked), &[' ']));
    // The digits of a table.
    let is_same = filed.len() == all.len() && filed.iter().zip(&all).all(|(a, b)| (a - b).abs() < 1e-7);
    assert!(is_same, "{filed:?} {all:?}");
}

#[test]
fn units_and_methods_are_heeded() {
    let run = |start: &str, method: &str| {
        let start = ["run", "trestle", "--start", start, "--start", "beta=1", "--method", method, "--json"];
        json(&start)["final_state"]["alpha'"].as_f64().expect("a number")
    };
    let (degrees, radians) = (run("alpha=60deg", "taylor"), run("alpha=pi/3", "dop853"));
    assert!((degrees - radians).abs() < 1e-9 && degrees != 0.0, "{degrees} {radians}");
}

/// What a run takes where nothing is said can be looked up before it is made.
#[test]
fn defaults_are_reported_by_list_and_help() {
    let listed = run_program(&["list", "trestle"]);
    let helped = run_program(&["run", "trestle", "--help"]);
    for text in [&listed, &helped] {
        for part in ["m = 6, p = 70, l = 2, g = 9.81", "the nominal figure", "y(C) = 0", "1e-12"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
    // A thousand times √(l/g).
    let models = json(&["list", "trestle", "--json"]);
    let limit = models[0]["default_run"]["limit"].as_f64().expect("a time");
    assert!((limit - 1000.0 * (2.0f64 / 9.81).sqrt()).abs() < 1e-9, "{limit}");
    assert_eq!(models[0]["default_run"]["until"][0], "y(C) = 0");
    assert!(!run_program(&["run", "--help"]).contains("y(C) = 0"));
}

#[test]
fn a_model_that_is_none_is_not_listed() {
    assert_eq!(run(&["list", "trestel"]).status.code(), Some(2));
}

/// Notes on the standard error output of what is allowed and hardly meant.
#[test]
fn what_is_hardly_meant_is_noted() {
    let noted = |arguments: &[&str]| errors(&run(&[&["run", "trestle"], arguments].concat()));
    let turned = noted(&["--start", "alpha=60", "--start", "beta=60deg", "--limit", "0.1"]);
    assert!(turned.contains("alpha = 60 is 60 rad; for degrees write alpha=60deg"), "{turned}");
    assert!(!turned.contains("beta = "), "{turned}");
    assert!(!noted(&["--start", "alpha=6", "--limit", "0.1"]).contains("degrees"));
    // The trestle is symmetrical and stays so.
    let always = noted(&["--until", "x = 0", "--limit", "0.1"]);
    assert!(always.contains("`x = 0` holds at the start: it is met when it becomes true again"), "{always}");
    let not_met = "note: at t = 0.1000: the run ends here, and `y(C) = 0` was not met\n";
    assert_eq!(noted(&["--limit", "0.1"]), not_met);
    assert_eq!(noted(&["--until", "t = 0.1 s"]), "");
    let ended = noted(&["--limit", "50"]);
    assert!(
        ended.contains("the model's default condition `y(C) = 0` has ended the run before t = 50"),
        "{ended}"
    );
}

/// Its top stays above its start: what its coordinate has is rounding.
#[test]
fn rounding_is_printed_as_zero() {
    let table = run_program(&["run", "trestle", "--limit", "0.5", "--every", "0.1"]);
    let events = run_program(&["run", "trestle"]);
    for text in [&table, &events] {
        assert!(!["e-16", "e-17", "e-18", "e-15", "e-3"].iter().any(|tiny| text.contains(tiny)), "{text}");
    }
}

#[test]
fn a_small_sweep_shows_its_members() {
    let text = run_program(&[
        "sweep",
        "trestle",
        "--vary",
        "p=1,2",
        "--observe",
        "end",
        "--observe",
        "end y(C)/l",
        "--limit",
        "0.1",
    ]);
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(lines[1], ["p", "end", "end", "y(C)/l"], "{text}");
    assert_eq!((lines[2][0], lines[3][0], lines[2][1]), ("1", "2", "end"), "{text}");
    let large =
        run_program(&["sweep", "trestle", "--vary", "p=1:70:30", "--observe", "end", "--limit", "0.01"]);
    assert_eq!(large.lines().count(), 3, "{large}");
}

/// Rows are at multiples from there, and a time before is refused.
#[test]
fn a_run_begins_at_its_time() {
    let begun = ["run", "trestle", "--start", "t=0.25", "--until", "t = 1", "--every", "0.5", "--csv", "-"];
    let output = run(&begun);
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    let times: Vec<&str> = table.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    assert_eq!(times, ["0.25", "0.5", "1"], "{table}");
    assert!(errors(&output).contains("0.2500000  start"), "{}", errors(&output));
    let early = run(&[&begun[..], &["--at", "0.1"]].concat());
    assert!(errors(&early).contains("--at 0.1: the run begins at t = 0.25"), "{}", errors(&early));
}
