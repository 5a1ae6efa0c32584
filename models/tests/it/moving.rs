//! Pictures that move, of all models, against the runs they were drawn from.

use liftoff::Trajectory;
use liftoff_analysis::{Linearisation, Mode, Subject};
use liftoff_models::models;
use liftoff_studio::animation::{About, ModeShape, mode_shapes, moving_picture};
use liftoff_studio::plot::with_theme;
use std::process::Command;

fn drawn(title: &str, record: &Trajectory) -> String {
    with_theme(&moving_picture(record, &About { title, ..About::default() }, None).expect("drawn"))
}

/// The value of an attribute in the text of one element.
fn attribute<'a>(element: &'a str, name: &str) -> &'a str {
    let value = element.split_once(&format!(" {name}=\"")).and_then(|(_, rest)| rest.split_once('"'));
    value.unwrap_or_else(|| panic!("no {name} in {element:.80}")).0
}

fn numbers(text: &str, between: char) -> Vec<f64> {
    text.split(between).map(|number| number.parse().expect("a number")).collect()
}

/// Every element ends, in the order of nesting; no attribute stands twice, and no bare `<` or `&`
/// anywhere.
fn assert_well_formed(svg: &str) {
    let mut open: Vec<&str> = Vec::new();
    for piece in svg.split('<').skip(1) {
        let (tag, text) = piece.split_once('>').expect("an element ends");
        let entities = text.split('&').skip(1).chain(tag.split('&').skip(1));
        assert!(
            entities.into_iter().all(|rest| rest.split_once(';').is_some_and(|(name, _)| name.len() < 6))
        );
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name));
            continue;
        }
        let mut names: Vec<&str> = tag.split("=\"").filter_map(|part| part.rsplit(' ').next()).collect();
        // After the last value there is no name.
        names.pop();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(count, names.len(), "{tag:.200}");
        assert_eq!(tag.matches('"').count(), 2 * count, "{tag:.200}");
        if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap_or(tag));
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

/// Where a point is on the screen: parts of the period, and pixels.
fn track(svg: &str, point: &str) -> Vec<(f64, [f64; 2])> {
    let mark = format!("data-point=\"{point}\"");
    let line = svg.lines().find(|line| line.contains(&mark)).expect("every point is drawn");
    let place = |text: &str| <[f64; 2]>::try_from(numbers(text, ' ')).expect("x and y");
    let Some((_, moves)) = line.split_once("<animateTransform") else {
        let at = line.split("translate(").nth(1).and_then(|rest| rest.split(')').next());
        return vec![(0.0, place(at.expect("a place")))];
    };
    let places = attribute(moves, "values").split(';').map(place);
    numbers(attribute(moves, "keyTimes"), ';').into_iter().zip(places).collect()
}

/// Places are rounded to a tenth of a pixel, and their times to 1e-4 of the period, so that a place
/// is between those that the run has a little before and after.
fn assert_shows(svg: &str, record: &Trajectory) {
    let root = &svg[..svg.find(">\n").expect("the root")];
    let [scale, x0, y0, pace] = ["data-scale", "data-x", "data-y", "data-pace"]
        .map(|name| attribute(root, name).parse::<f64>().expect("a number"));
    let period: f64 = attribute(svg, "dur").trim_end_matches('s').parse().expect("a time");
    let [start, end] = record.interval();
    for point in record.layout().points {
        let [x, y] = ["x", "y"].map(|axis| record.function(&format!("{axis}({point})")).expect("a point"));
        for (key, at) in track(svg, point) {
            let around = (-4..=4).map(|i| {
                let t = start + pace * period * (key + 1.5e-5 * f64::from(i));
                let t = t.clamp(start, end);
                [x0 + scale * x(t), y0 - scale * y(t)]
            });
            let around: Vec<[f64; 2]> = around.collect();
            for k in 0..2 {
                let least = around.iter().map(|place| place[k]).fold(f64::INFINITY, f64::min);
                let most = around.iter().map(|place| place[k]).fold(f64::NEG_INFINITY, f64::max);
                assert!(
                    least - 0.0501 <= at[k] && at[k] <= most + 0.0501,
                    "{point} at {key}: {at:?} {around:?}"
                );
            }
        }
    }
}

#[test]
fn every_model_moves_as_its_run() {
    for model in models().iter() {
        let record = model.run(&model.default_run()).expect("a run");
        let svg = drawn(model.name(), &record);
        assert_well_formed(&svg);
        assert!(svg.len() < 150_000 && !svg.contains("NaN") && !svg.contains("inf"), "{}", model.name());
        assert!(!svg.contains("href") && !svg.contains("<script"), "{}", model.name());
        assert_shows(&svg, &record);
    }
}

/// A bar from O swings by φ = a cos θ, and in quadrature by φ = −a sin θ, its end by 0.12 of its
/// length at most.
#[test]
fn mode_shapes_swing_about_the_position_at_rest() {
    let model = models().find("pendulum").expect("a model");
    let parameters = model.default_run().parameters;
    let l = parameters.iter().find(|(name, _)| name == "l").expect("a length").1;
    let modes = [("real", [1.0, 0.0]), ("imaginary, 1 < 2", [0.0, 3.0])]
        .map(|(words, part)| ModeShape { words: words.to_owned(), shape: vec![part] });
    let svg = with_theme(&mode_shapes(model, &parameters, &[0.0], &modes).expect("drawn"));
    assert_well_formed(&svg);
    assert!(svg.contains(">imaginary, 1 &lt; 2<"));
    let [scale, x0, y0] = ["data-scale", "data-x", "data-y"]
        .map(|name| attribute(&svg, name).parse::<f64>().expect("a number"));
    let panels: Vec<&str> = svg.split("<g transform=\"translate(0 ").skip(1).collect();
    assert_eq!(panels.len(), 2);
    for (panel, quadrature) in panels.iter().zip([0.0, 0.25]) {
        let moving = panel.lines().filter(|line| line.contains("animateTransform"));
        let moving: Vec<&str> = moving.filter(|line| line.contains("data-point=\"A\"")).collect();
        assert_eq!(moving.len(), 1);
        let track = track(moving[0], "A");
        // 24 steps and the beginning of the next cycle.
        assert_eq!(track.len(), 26);
        for (i, (key, at)) in track[..25].iter().enumerate() {
            let part = i as f64 / 24.0;
            let phi = 0.12 * (std::f64::consts::TAU * (part + quadrature)).cos();
            let expected = [x0 + scale * l * phi.sin(), y0 + scale * l * phi.cos()];
            let off = (at[0] - expected[0]).abs().max((at[1] - expected[1]).abs());
            // Tenths of a pixel, and 1e-4 of the period.
            assert!(
                off < 0.0501 + 1e-5 * scale * l && (key - part).abs() < 0.51e-4,
                "{part}: {key} {at:?} {expected:?}"
            );
        }
    }
}

/// About the default start of every model that has modes there.
#[test]
fn modes_of_every_model_are_drawn() {
    let mut drawn = 0;
    for model in models().iter() {
        let spec = model.default_run();
        let simulation = model.simulation(&spec).expect("a start");
        let precise = model.precise(&spec.parameters).expect("equations");
        let subject = Subject::new(&simulation, precise).expect("a start");
        // Those that depend on the time, or have friction in hinges, are refused.
        let Ok(linear) = Linearisation::compute(&subject, subject.touching()) else { continue };
        let shape = |mode: &Mode| mode.shape.iter().map(|x| [x.re, x.im]).collect();
        let modes: Vec<ModeShape> = linear
            .modes()
            .iter()
            .map(|mode| ModeShape { words: String::new(), shape: shape(mode) })
            .collect();
        let svg = with_theme(
            &mode_shapes(model, &spec.parameters, &subject.positions(), &modes).expect("a picture"),
        );
        assert_well_formed(&svg);
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{}", model.name());
        let moving = svg.split("<g transform=\"translate(0 ").skip(1);
        assert!(moving.into_iter().all(|panel| panel.contains("<animate")), "{}", model.name());
        drawn += modes.len();
    }
    assert!(drawn > 60, "{drawn}");
}

/// A closed contact with friction has a cone as wide as its coefficient says, about its normal; an
/// open one has none.
#[test]
fn cones_are_as_wide_as_friction_is() {
    let model = models().find("painleve").expect("a model");
    let record = model.run(&model.default_run()).expect("a run");
    let svg = drawn("painleve", &record);
    let cone = svg.lines().find(|line| line.contains("data-cone=\"A\"")).expect("a cone");
    let places = |form: &str| -> Vec<f64> {
        form.split(['M', 'L', ' '])
            .filter(|text| !text.is_empty())
            .map(|text| text.parse().expect("a number"))
            .collect()
    };
    let [a, b, x, y, c, d] = places(attribute(cone, "d"))[..] else { panic!("{cone:.200}") };
    // Upright, μ = 1.6; places are rounded to a tenth of a pixel.
    for (across, up) in [(a - x, y - b), (c - x, y - d)] {
        assert!(
            (across.abs() / up - 1.6).abs() < 0.02 && (across.hypot(up) - 46.0).abs() < 0.2,
            "{cone:.200}"
        );
    }
    let free = record.segments().iter().any(|segment| segment.closed.is_empty() && segment.t0 < segment.t1);
    let shut = attribute(cone, "values").split(';').any(|form| {
        let ends = places(form);
        ends[0] == ends[2] && ends[1] == ends[3]
    });
    assert_eq!(shut, free);
}

/// Its words are those that `run` prints, and each appears at its time.
#[test]
fn events_are_named_at_their_times() {
    let model = models().find("zigzag-thread").expect("a model");
    let record = model.run(&model.default_run()).expect("a run");
    let svg = drawn("zigzag-thread", &record);
    let events = &record.events()[1..];
    for (event, name) in events.iter().zip(["BD cut", "C open", "A, E open", "B, D close"]) {
        let mark = format!(">{name}, ");
        let line = svg.lines().find(|line| line.contains(&mark)).expect("named");
        let period: f64 = attribute(line, "dur").trim_end_matches('s').parse().expect("a time");
        let shown = numbers(attribute(line, "keyTimes"), ';')[1] * period;
        // Five times slower; keys are rounded to 1e-4 of the period.
        assert!((shown - 5.0 * event.t).abs() <= 0.51e-4 * period, "{name}: {shown} {}", event.t);
    }
}

fn animate(arguments: &[&str]) -> std::process::Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_liftoff"));
    command.arg("animate").args(arguments).output().expect("the command starts")
}

#[test]
fn the_moving_picture_of_the_readme_is_the_one_drawn() {
    let file = std::env::temp_dir().join(format!("liftoff-moving-{}.svg", std::process::id()));
    let path = file.to_str().expect("UTF-8");
    let output = animate(&["zigzag-thread", "--cut", "BD=t = 0.1", "--slower", "10", "--out", path]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let svg = std::fs::read_to_string(&file).expect("the file is there");
    std::fs::remove_file(file).expect("it can go");
    assert!(svg == include_str!("../../moving.svg"), "copy what README.md draws");
}

#[test]
fn only_a_picture_has_a_pace() {
    for (arguments, message) in [
        (["ladder", "--slower", "2", "--out", "a.html"], "`--slower` is for a picture"),
        (["ladder", "--slower", "0", "--out", "a.svg"], "a number above 0 is needed"),
    ] {
        let output = animate(&arguments);
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&output.stderr).contains(message));
    }
}
