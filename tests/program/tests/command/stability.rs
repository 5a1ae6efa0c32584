//! Five things asked of a model's default run.

use crate::program::{run, temporary_path};
use serde_json::Value;

#[test]
fn a_users_model_is_judged_and_written_on_a_page() {
    let directory = temporary_path("stability");
    let out = directory.to_str().expect("UTF-8");
    let output = run(&["stability", "trestle", "--short", "--json", "--out", out]);
    let page = std::fs::read_to_string(directory.join("stability.html")).expect("a page");
    std::fs::remove_dir_all(&directory).expect("removed");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
    let told: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let cases = told["cases"].as_array().expect("a list");
    for group in ["tolerances", "methods", "forms", "scaling", "energy"] {
        let own = cases.iter().filter(|case| case["id"].as_str().is_some_and(|id| id.starts_with(group)));
        assert!(own.count() > 0, "{group}");
        assert!(page.contains(&format!("id={group}")), "{group}");
    }
    // Nothing drives or damps a ladder on a smooth floor, and its numbers all have names.
    for case in cases {
        let measured = case["measured"].as_str().expect("a text");
        assert!(measured.contains(" = "), "{case}");
    }
}

#[test]
fn a_group_can_be_asked_for_alone() {
    let directory = temporary_path("energy");
    let output = run(&["stability", "energy", "--out", directory.to_str().expect("UTF-8")]);
    std::fs::remove_dir_all(&directory).expect("removed");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && text.contains("1 of 1 cases pass"), "{text}");
}
