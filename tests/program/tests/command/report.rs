//! A page of all that there is to know of a model.

use crate::program::{errors, run, temporary_path};

#[test]
fn a_report_is_one_page_that_needs_nothing_beside_itself_and_an_index() {
    let directory = temporary_path("report");
    let output = run(&["report", "trestle", "--out", directory.to_str().expect("UTF-8")]);
    let [page, index] = ["trestle", "index"]
        .map(|name| std::fs::read_to_string(directory.join(format!("{name}.html"))).expect("a page"));
    std::fs::remove_dir_all(&directory).expect("removed");
    assert!(output.status.success(), "{}", errors(&output));
    assert!(!String::from_utf8_lossy(&output.stdout).contains("missing"), "{output:?}");
    for part in ["model", "equations", "modes", "run", "pictures", "motion", "time", "checks"] {
        assert!(page.contains(&format!("<h2 id={part}>")), "{part}");
    }
    for (what, times) in
        [("<figure", 4), ("<iframe", 1), ("alpha′", 1), ("m/s²", 1), ("Errors against double-double", 1)]
    {
        assert!(page.matches(what).count() >= times, "{what}");
    }
    for page in [&page, &index] {
        assert!(!page.contains("src=\"http") && !page.contains("href=\"http") && !page.contains("@import"));
    }
    assert!(index.contains("href=\"trestle.html\"") && index.contains("A folding trestle"));
}
