//! The page of a motion.

use crate::program::{errors, run, run_program, temporary_path};

#[test]
fn a_motion_becomes_a_page_of_its_own() {
    let file = temporary_path("motion.html");
    let path = file.to_str().expect("UTF-8");
    let said =
        run_program(&["animate", "trestle", "--until", "t = 0.5", "--output", "N(A) / p", "--out", path]);
    let page = std::fs::read_to_string(&file).expect("a page");
    std::fs::remove_file(&file).expect("removed");
    assert_eq!(said.trim_end(), path);
    assert!(page.contains("<h1>trestle</h1>") && page.contains(r#"{"name":"N(A) / p","label":"#));
    // The page is self-contained.
    assert!(!page.contains("src=") && !page.contains("href=") && !page.contains("@import"));
}

#[test]
fn what_cannot_be_drawn_or_written_is_reported_in_a_line() {
    let output = run(&["animate", "trestle", "--output", "betta"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(errors(&output).contains("beta") && errors(&output).lines().count() == 1, "{}", errors(&output));
    let output = run(&["animate", "trestle", "--until", "t = 0.1", "--out", "/dev/null/motion.html"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        errors(&output).starts_with("error: cannot write /dev/null/motion.html: "),
        "{}",
        errors(&output)
    );
}
