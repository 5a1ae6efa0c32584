//! What somebody tries first is understood, or told what to write instead.

use crate::program::{errors, run, run_program, temporary_path};

const MODEL: &str = "trestle";

/// The last event of a run with these options.
fn last(options: &[&str]) -> String {
    let text = run_program(&[&["run", MODEL], options].concat());
    text.lines().last().expect("an event").to_owned()
}

/// Rates, degrees, comparisons and logic in all their spellings.
#[test]
fn conditions_have_the_spellings_of_other_languages() {
    let stop = |condition: &str| last(&["--until", condition]).split(" (").next().expect("words").to_owned();
    for (one, other) in [
        ("alpha' < -1", "rate(alpha) < -1"),
        ("alpha = 0.5", "alpha == 0.5"),
        ("alpha < pi/6", "alpha < 30deg"),
        ("alpha < pi/6", "alpha <= 30 deg && t > 0.01"),
        ("alpha < pi/6", "(alpha < 30°) and rate(alpha) < 0"),
        ("alpha < pi/6", "alpha < 30deg || t = 100"),
        ("alpha < pi/6", "t > 100 or alpha < 30deg"),
    ] {
        assert_eq!(stop(one), stop(other), "{other}");
    }
    let refused = run(&["run", MODEL, "--until", "alpha = 1 and t > 1"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(errors(&refused).contains("`a > b` is met where a rises through b"), "{}", errors(&refused));
}

#[test]
fn rates_have_both_names_wherever_they_are_given() {
    let outputs = |rate: &str| {
        let text = run_program(&["run", MODEL, "--output", rate, "--start", &format!("{rate}=-1")]);
        // The head is as wide as the name.
        text.lines().skip(1).flat_map(str::split_whitespace).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(outputs("alpha'"), outputs("rate(alpha)"));
    let swept = |rate: &str| {
        run_program(&["sweep", MODEL, "--vary", &format!("{rate}=-1:0:3"), "--observe", "end t"])
    };
    assert_eq!(swept("alpha'"), swept("rate(alpha)"));
}

#[test]
fn degrees_are_numbers_in_every_option() {
    let same = |one: &[&str], other: &[&str]| assert_eq!(run_program(one), run_program(other), "{other:?}");
    same(
        &["run", MODEL, "--start", "alpha=pi/3", "--start", "beta=pi/3"],
        &["run", MODEL, "--start", "alpha=60deg", "--start", "beta=60 deg"],
    );
    let sweep = |from: &str, to: &str, until: &str| {
        let varied = format!("alpha={from}:{to}:3");
        run_program(&[
            "sweep",
            MODEL,
            "--vary",
            &varied,
            "--start",
            "beta=1",
            "--until",
            until,
            "--observe",
            "end t",
        ])
    };
    assert_eq!(sweep("pi/6", "pi/3", "alpha = pi/18"), sweep("30deg", "60deg", "alpha = 10deg"));
}

/// The trestle's start has other coordinates too: what they became is told.
#[test]
fn what_a_start_is_completed_by_is_told() {
    let output = run(&["run", MODEL, "--start", "alpha=60deg", "--limit", "0.01"]);
    let notes = errors(&output);
    assert!(notes.contains("the start is completed by beta = "), "{notes}");
    let default = errors(&run(&["run", MODEL, "--limit", "0.01"]));
    assert!(!default.contains("completed"), "{default}");
}

#[test]
fn coordinates_are_told_with_what_they_measure() {
    let text = "alpha (rad): angle of AC from the right, counter-clockwise; beta (rad): angle of CB from the right, \
                clockwise; x (m): x of C; y (m): y of C";
    for arguments in [&["list", MODEL][..], &["run", MODEL, "--help"]] {
        let listed = run_program(arguments);
        assert!(listed.contains(text), "{listed}");
    }
}

#[test]
fn a_sweep_whose_members_all_fail_fails() {
    let sweep = |range: &str| run(&["sweep", MODEL, "--vary", range, "--observe", "end t"]);
    let failed = sweep("l=-2,-1");
    assert_eq!(failed.status.code(), Some(1), "{}", errors(&failed));
    assert!(errors(&failed).contains("every member has failed"));
    assert!(String::from_utf8_lossy(&failed.stdout).contains("2 failed"));
    assert_eq!(sweep("l=-1,1").status.code(), Some(0));
    let large = sweep("l=1:2:30");
    assert!(errors(&large).contains("a table of all members is written by --csv FILE"));
}

#[test]
fn a_loop_that_cannot_close_says_by_what_length() {
    let file = temporary_path("loop.rs");
    let text = "#[derive(BarSystem)] #[bar(OA, mass = 1, length = a)] #[bar(AB, mass = 1, length = 2.2)]
        #[bar(BC, mass = 1, length = 0.5)] #[pin(O = (0, 0))] #[pin(C = (3, 0))]
        #[figure(A = (0.4, 0.3), B = (2.6, 0.3))] #[coordinate(phi = angle(OA), from = right)] #[run(limit = 1)]
        struct FourBar { #[value = 0.5] a: f64 }";
    std::fs::write(&file, text).expect("a file");
    let name = file.to_str().expect("UTF-8");
    // 3 m between the pins, 0.1 + 2.2 + 0.5 m of bars.
    let refused = errors(&run(&["run", name, "--set", "a=0.1"]));
    assert!(refused.contains("pin C cannot close: 0.2000 are missing (m, "), "{refused}");
    std::fs::write(&file, text.replace("2.2", "1")).expect("a file");
    let refused = errors(&run(&["run", name]));
    assert!(refused.contains("the loop O–A–B–C cannot close") && refused.contains("it lacks 1"), "{refused}");
    std::fs::remove_file(file).expect("removed");
}

/// A pendulum rests below and above; the nearest is told first, without whole turns.
#[test]
fn equilibria_are_told_from_the_nearest_on_without_whole_turns() {
    let file = temporary_path("pendulum.rs");
    let text = "#[derive(BarSystem)] #[gravity(9.81)] #[bar(OA, mass = 1, length = 1)] #[pin(O = (0, 0))]
        #[figure(A = (0, -1))] #[coordinate(phi = angle(OA), from = down)] struct Pendulum {}";
    std::fs::write(&file, text).expect("a file");
    let name = file.to_str().expect("UTF-8");
    for (start, first, second) in [("0.1", "phi = 0", "phi = 3.14159"), ("16", "phi = 3.14159", "phi = 0")] {
        let text = run_program(&["equilibrium", name, "--start", &format!("phi={start}")]);
        let places: Vec<&str> =
            text.lines().filter(|line| line.starts_with("  phi")).map(str::trim).collect();
        assert_eq!(places, [first, second], "{text}");
    }
    std::fs::remove_file(file).expect("removed");
}

/// The sum of two reactions says of which.
#[test]
fn the_reaction_of_two_supports_is_told_as_their_sum() {
    let file = temporary_path("mirrored.rs");
    let text = "#[derive(BarSystem)] #[gravity(9.81)] #[bar(AC, mass = 1, length = 1)] #[bar(CB, mass = 1, length = 1)]
        #[support(A = floor)] #[support(B = floor)] #[figure(A = (-0.6, 0), C = (0, 0.8))]
        #[coordinate(phi = angle(AC), from = horizontal)] #[mirror(x = 0)] #[run(until = \"phi = 30 deg\")] struct Frame {}";
    std::fs::write(&file, text).expect("a file");
    let name = file.to_str().expect("UTF-8");
    assert!(run_program(&["explain", name]).contains("\n  N(A, B) = N(A) + N(B)\n"));
    assert!(run_program(&["conditions", name]).contains("\n  N(A, B) = N(A) + N(B)\n"));
    let page = temporary_path("mirrored.html");
    run_program(&["animate", name, "--out", page.to_str().expect("UTF-8")]);
    let written = std::fs::read_to_string(&page).expect("written");
    assert!(written.contains("\"label\":\"N(A) + N(B)\""));
    [file, page].into_iter().for_each(|path| std::fs::remove_file(path).expect("removed"));
}

/// Sides that cross whatever the parameters are refused, those that cross with the values of a run
/// told.
#[test]
fn an_outline_that_crosses_itself_is_refused_or_told() {
    let file = temporary_path("plate.rs");
    let said = |points: &str, more: &[&str]| {
        let text = format!(
            "#[derive(BarSystem)] #[body(plate, points({points}), mass = 1, inertia = 0.2, centre = (0.5, 0.5))]
             #[pin(A = (0, 0))] #[run(start = \"theta_plate' = 1\", limit = 0.1)]
             struct Plate {{ #[value(1)] b: f64 }}"
        );
        std::fs::write(&file, text).expect("a file");
        let output = run(&[&["run", file.to_str().expect("UTF-8")], more].concat());
        (output.status.success(), errors(&output))
    };
    let (runs, crossed) = said("A = (0, 0), B = (b, 1), C = (b, 0), D = (0, 1)", &[]);
    let cure = "sides A–B and C–D cross; list the corners in order around it, A, C, B, D";
    assert!(!runs && crossed.contains(cure) && crossed.contains("body `plate`"), "{crossed}");
    let around = "A = (0, 0), C = (1, 0), B = (b, 1), D = (0, 1)";
    assert_eq!(said(around, &[]), (true, String::new()));
    let (runs, crossed) = said(around, &["--set", "b=-2"]);
    assert!(runs && crossed.contains("the outline A–C–B–D: sides"), "{crossed}");
    std::fs::remove_file(file).expect("removed");
}
