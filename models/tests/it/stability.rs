//! The stability suite, shortened where runs are long; `liftoff stability` runs it in full.

use liftoff_models::stability::GROUPS;
use liftoff_verification::cases::{Effort, Outcome, Verdict, text};
use std::process::Command;
use std::time::Duration;

fn judge(name: &str) {
    let group = GROUPS.iter().find(|group| group.name == name).expect("the group exists");
    let cases = group.cases(Effort::Short);
    assert!(!cases.is_empty());
    let verdicts: Vec<_> = cases.into_iter().map(|case| case.judge(Duration::from_secs(120))).collect();
    // What does not finish is not judged, and no test that passes.
    let is_open = |verdict: &Verdict| verdict.fails() || verdict.outcome == Outcome::NotJudged;
    let wrong: Vec<_> = verdicts.into_iter().filter(is_open).collect();
    assert!(wrong.is_empty(), "\n{}", text(&wrong));
}

macro_rules! groups {
    ($($name:ident),*) => {
        const TESTED: &[&str] = &[$(stringify!($name)),*];
        $(#[test]
        fn $name() {
            judge(stringify!($name));
        })*
    };
}

groups!(
    springs, ratios, massless, starts, units, feet, grazing, zeno, together, edges, long, loops, near,
    drives, chart, extremes, friction, buffers, dependent, redundant, loads, impacts, inputs
);

#[test]
fn every_group_is_tested() {
    let names: Vec<_> = GROUPS.iter().map(|group| group.name).collect();
    assert_eq!(names, TESTED);
}

#[test]
fn the_command_prints_json_and_writes_a_page() {
    let directory = std::env::temp_dir().join(format!("liftoff-stability-{}", std::process::id()));
    let arguments = ["stability", "chart", "--json", "--out"];
    let output = Command::new(env!("CARGO_BIN_EXE_liftoff")).args(arguments).arg(&directory).output();
    let output = output.expect("the command starts");
    let page = std::fs::read_to_string(directory.join("stability.html"));
    std::fs::remove_dir_all(&directory).expect("removed");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let cases = told["cases"].as_array().expect("a list");
    for case in cases {
        let id = case["id"].as_str().expect("a name");
        let texts = ["expected", "measured", "method", "scene", "source"].map(|key| case[key].as_str());
        assert!(texts.iter().all(|text| text.is_some_and(|text| !text.is_empty())), "{case}");
        assert_eq!(case["outcome"], "pass", "{case}");
        assert!(page.as_ref().expect("a page").contains(id.trim_start_matches("chart.")), "{id}");
    }
    assert_eq!(cases.len(), 3);
    let stranger = Command::new(env!("CARGO_BIN_EXE_liftoff")).args(["stability", "zebra"]).output();
    assert_eq!(stranger.expect("the command starts").status.code(), Some(2));
}

/// The verdicts on a model by the groups named.
fn verdicts(arguments: &[&str]) -> Vec<serde_json::Value> {
    let directory = std::env::temp_dir().join(format!("liftoff-{}-{}", arguments[0], std::process::id()));
    let mut command = Command::new(env!("CARGO_BIN_EXE_liftoff"));
    let output = command.arg("stability").args(arguments).arg("--json").arg("--out").arg(&directory).output();
    let output = output.expect("the command starts");
    std::fs::remove_dir_all(&directory).expect("removed");
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    told["cases"].as_array().expect("a list").clone()
}

#[test]
fn the_car_axis_is_the_same_in_other_units() {
    let cases = verdicts(&["car-axis", "scaling"]);
    assert!(cases.len() == 6 && cases.iter().all(|case| case["outcome"] == "pass"), "{cases:#?}");
}

/// The rod's coordinates stay zero: it is its reactions that are compared. The judge has looked at
/// the run of its own group.
#[test]
fn where_nothing_moves_reactions_are_compared() {
    let cases = verdicts(&["rod-on-three", "methods", "forms", "scaling", "judge"]);
    assert_eq!(cases.len(), 13);
    for case in cases {
        let [id, measured, judge] =
            ["id", "measured", "judge"].map(|key| case[key].as_str().expect("a text"));
        assert_eq!(case["outcome"], "pass", "{case}");
        assert!(id.starts_with("judge") || measured.contains("Δ reactions ="), "{case}");
        assert!(judge.starts_with("agrees"), "{case}");
    }
}
