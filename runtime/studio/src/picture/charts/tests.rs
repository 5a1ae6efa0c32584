//! Charts of small motions.

use super::*;
use crate::picture::examples::{ball, ladder};
use crate::picture::sample::Traced;
use crate::plot::{Annotations, Band};
use liftoff::Trajectory;

fn curve(record: &Trajectory, output: &str) -> Traced {
    traced(record, &record.function("t").unwrap(), &record.function(output).unwrap())
}

/// Words with their places, pixels.
fn words(svg: &str) -> Vec<([f64; 2], String)> {
    let attribute = |text: &str, name: &str| -> f64 {
        let from = text.split(&format!(" {name}=\"")).nth(1).unwrap();
        from.split('"').next().unwrap().parse().unwrap()
    };
    let parts = svg.split("<text").skip(1);
    let word = |part: &str| {
        let (head, rest) = part.split_once('>').unwrap();
        let text = rest.split("</text>").next().unwrap().trim().to_owned();
        ([attribute(head, "x"), attribute(head, "y")], text)
    };
    parts.map(word).collect()
}

#[test]
fn an_impact_leaves_two_values_at_one_time() {
    let record = ball();
    let jumps = curve(&record, "vy(P)").jumps();
    let [before, after] = jumps[0].1;
    assert!((before[0] - 0.5).abs() < 1e-12 && (after[0] - 0.5).abs() < 1e-12);
    assert!((before[1] + 4.0).abs() < 1e-9 && (after[1] - 2.0).abs() < 1e-9, "{before:?} {after:?}");
    assert_eq!(curve(&record, "y").jumps(), [], "its height does not jump");
}

/// Between its points the curve is where the motion is, to what is seen.
#[test]
fn straight_lines_between_the_points_follow_the_motion() {
    let record = ladder();
    for output in ["phi'", "N(A)", "N(B)", "V"] {
        let value = record.function(output).unwrap();
        let curve = curve(&record, output);
        let [low, high] = seen(curve.pieces.iter().flat_map(|piece| &piece.points).map(|p| p[1]));
        for pair in curve.pieces.iter().flat_map(|piece| piece.points.windows(2)) {
            let [a, b] = [pair[0], pair[1]];
            for part in [0.25, 0.5, 0.75] {
                let line = a[1] + part * (b[1] - a[1]);
                let off = (value(a[0] + part * (b[0] - a[0])) - line).abs();
                assert!(off < 2e-3 * (high - low), "{output} at {}: {off}", a[0]);
            }
        }
    }
}

#[test]
fn bands_cover_the_run_and_have_the_names_of_their_supports() {
    let record = ladder();
    let axis = Axis::linear("t", record.interval());
    let Annotations { bands, heads, .. } = EventMarks::over(&record, &axis, 800).annotations();
    let names: Vec<_> = bands.iter().map(|band| band.name.as_str()).collect();
    assert_eq!(names, ["on A, B", "on A"]);
    let ends = |band: &Band| band.range;
    assert_eq!([ends(&bands[0])[0], ends(&bands[1])[1]], record.interval());
    assert_eq!(ends(&bands[0])[1], ends(&bands[1])[0]);
    let marks: Vec<_> = heads.iter().map(|head| (head.at, head.text.as_str())).collect();
    assert_eq!(marks, [(bands[1].range[0], "B open")]);
}

#[test]
fn curves_of_one_unit_share_a_panel() {
    let record = ladder();
    let svg = Charts::new(&record).svg().unwrap();
    let names: Vec<String> = words(&svg).into_iter().map(|(_, text)| text).collect();
    for name in ["φ, rad", "x, y, m", "N(A), N(B), N", "T, V, E, J", "t, s", "on A, B", "B open"] {
        assert!(names.iter().any(|known| known == name), "{name}: {names:?}");
    }
    assert_eq!(names.iter().filter(|name| *name == "t, s").count(), 1, "the panels share one axis");
    let svg = Charts::new(&record).outputs(["N(A) / (m * g)", "phi * 180 / pi"]).svg().unwrap();
    for name in [">N(A) / (m · g)", ">φ · 180 / π, °"] {
        assert!(svg.contains(name), "{name}");
    }
}

#[test]
fn words_stay_on_the_sheet() {
    for record in [ladder(), ball()] {
        for size in [(300, 300), (860, 900)] {
            let svg = Charts::new(&record).size(Some(size.0), Some(size.1)).svg().unwrap();
            for ([x, y], text) in words(&svg) {
                assert!((0.0..=f64::from(size.0)).contains(&x), "{text} at {x}");
                assert!((0.0..=f64::from(size.1)).contains(&y), "{text} at {y}");
            }
        }
    }
}

#[test]
fn what_is_nowhere_finite_is_an_empty_panel_and_a_pole_does_not_flatten_the_rest() {
    let record = ladder();
    let svg = Charts::new(&record).outputs(["sqrt(-1 - phi^2)"]).svg().unwrap();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    let points = curve(&record, "1 / (phi - 1)^3").joined();
    let most = seen(points.iter().map(|p| p[1]));
    assert!(points.iter().any(|p| p[1].is_nan()), "a gap where the pole is");
    assert!(most[1] - most[0] < 1e5, "{most:?}");
}

#[test]
fn an_unknown_output_is_reported_with_the_nearest() {
    let record = ladder();
    let error = Charts::new(&record).outputs(["ph"]).svg().unwrap_err();
    assert_eq!(error.to_string(), "no name `ph`; did you mean `phi`?");
    let error = Charts::new(&record).against("N(C)").svg().unwrap_err();
    assert_eq!(error.to_string(), "no support `C`; known: A, B");
}

/// Many events of one kind are one word; against an angle they are numbers with a list.
#[test]
fn events_are_reported_once() {
    let record = ball();
    let axis = Axis::linear("t", record.interval());
    let impacts = record.events().iter().filter(|event| event.kind == liftoff::EventKind::Impact).count();
    let annotations = EventMarks::over(&record, &axis, 860).annotations();
    assert!(impacts > 20);
    assert_eq!(
        annotations.heads.iter().filter(|head| head.text == format!("P impact × {impacts}")).count(),
        1
    );
    let against = EventMarks::beside(&ladder(), 860).annotations();
    assert!(against.notes[0].starts_with("1: B open at t = 0."), "{:?}", against.notes);
}
