//! Pictures of all models, and the command that draws them.

mod forms;

use liftoff_models::models;
use liftoff_studio::picture::{Charts, clearest_pose, drawing};
use std::path::PathBuf;
use std::process::{Command, Output};

/// A word of a drawing: what it says, and about where it is.
struct Word {
    text: String,
    least: [f64; 2],
    most: [f64; 2],
}

fn attribute(tag: &str, name: &str) -> f64 {
    let value = tag.split(&format!(" {name}=\"")).nth(1).and_then(|rest| rest.split('"').next());
    value.and_then(|value| value.parse().ok()).unwrap_or(f64::NAN)
}

/// Letters are at least a third as wide as high, capitals two thirds as high as the font.
fn words(svg: &str) -> Vec<Word> {
    let lines = svg.lines().filter(|line| line.starts_with("<text"));
    let word = |line: &str| {
        let (x, y, size) = (attribute(line, "x"), attribute(line, "y"), attribute(line, "font-size"));
        let parts = line.split('<').filter_map(|part| part.split_once('>'));
        let text: String = parts.map(|(_, text)| text).collect();
        let width = text.chars().count() as f64 * size / 3.0;
        Word { text, least: [x, y - 0.6 * size], most: [x + width, y] }
    };
    lines.map(word).collect()
}

#[test]
fn in_no_drawing_is_a_word_over_another_or_off_the_sheet() {
    for model in models().iter() {
        let still = clearest_pose(model, &model.default_run()).expect("a pose");
        let svg = drawing(&still);
        let size = [attribute(&svg, "width"), attribute(&svg, "height")];
        let words = words(&svg);
        assert!(words.len() > 2, "{}", model.name());
        for (i, a) in words.iter().enumerate() {
            let inside = (0..2).all(|k| a.least[k] >= 0.0 && a.most[k] <= size[k]);
            assert!(inside, "{}: {} is off the sheet", model.name(), a.text);
            for b in &words[..i] {
                let over = (0..2).all(|k| a.least[k] < b.most[k] && b.least[k] < a.most[k]);
                assert!(!over, "{}: {} over {}", model.name(), a.text, b.text);
            }
        }
    }
}

#[test]
fn every_coordinate_is_drawn() {
    for model in models().iter() {
        let svg = drawing(&clearest_pose(model, &model.default_run()).expect("a pose"));
        let slanted = svg.matches("font-style=\"italic\"").count();
        assert!(slanted >= model.layout().coordinates.len(), "{}", model.name());
    }
}

#[test]
fn every_default_run_has_its_charts() {
    for name in ["falling-pair", "zigzag-thread", "bouncing-bar", "squeezer", "looping", "folded-chain"] {
        let model = models().find(name).expect("a model");
        let record = model.run(&model.default_run()).expect("a run");
        let svg = Charts::new(&record).svg().expect("charts");
        assert!(svg.contains("t, s") && svg.contains("T, V, ") && !svg.contains("NaN"), "{name}");
    }
}

fn plot(arguments: &[&str]) -> (Output, PathBuf) {
    let name = arguments.join("-").replace(['/', ' ', '=', '\''], "_");
    let file = std::env::temp_dir().join(format!("liftoff-{}-{name}.svg", std::process::id()));
    let mut command = Command::new(env!("CARGO_BIN_EXE_liftoff"));
    let output =
        command.arg("plot").args(arguments).arg("--out").arg(&file).output().expect("the command starts");
    (output, file)
}

fn drawn(arguments: &[&str]) -> String {
    let (output, file) = plot(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), file.display().to_string());
    let svg = std::fs::read_to_string(&file).expect("the file is there");
    std::fs::remove_file(file).expect("it can go");
    svg
}

#[test]
fn the_options_tell_which_picture_is_meant() {
    assert!(drawn(&["ladder"]).contains("N(A), N(B), N"));
    assert!(drawn(&["ladder", "--output", "gap(B)"]).contains("gap(B), m"));
    assert!(drawn(&["ladder", "--output", "N(B)", "--against", "phi"]).contains("φ, rad"));
    assert!(drawn(&["ladder", "--trail", "B"]).contains("path of B"));
    assert!(drawn(&["ladder", "--picture", "drawing"]).contains(" = 1 m<"));
    let portrait = drawn(&["pendulum", "--also", "phi=0,phi'=3"]);
    assert!(portrait.contains("φ\u{307}, rad/s") && portrait.contains("φ=0,φ\u{307}=3"));
}

#[test]
fn mistakes_are_reported_in_a_line_with_the_nearest_name() {
    for (arguments, message) in [
        (["ladder", "--output", "ph"], "no name `ph`; did you mean `phi`?"),
        (["ladder", "--trail", "BB"], "no point `BB`; did you mean `B`?"),
        (["lader", "--positions", "3"], "no model `lader`; did you mean `ladder`?"),
    ] {
        let (output, _) = plot(&arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert_eq!(String::from_utf8_lossy(&output.stderr), format!("error: {message}\n"));
    }
}

#[test]
fn a_file_that_cannot_be_written_is_reported() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_liftoff"));
    let output = command.args(["plot", "ladder", "--out", "/dev/null/a.svg"]).output().expect("it starts");
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).starts_with("error: cannot write /dev/null/a.svg: "));
}

/// Without inner masses the free phase is singular as the inner bars pass the horizontal.
#[test]
fn a_run_that_stops_short_is_drawn_as_far_as_it_came() {
    let (output, file) = plot(&["zigzag", "--set", "m1=0", "--tol", "1e-6"]);
    assert_eq!(output.status.code(), Some(1));
    let svg = std::fs::read_to_string(&file).expect("the motion so far");
    std::fs::remove_file(file).expect("it can go");
    assert!(svg.contains("C open") && String::from_utf8_lossy(&output.stderr).starts_with("error: "));
}
