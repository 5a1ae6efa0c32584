//! Time histories as SVG elements.

use super::timeline::Timeline;
use crate::plot::svg::plane::{Px, along, middle};
use core::fmt::Write;

/// A number in pixels, to a tenth, without trailing zeros.
pub(super) fn number(x: f64) -> String {
    format!("{}", (10.0 * x).round() / 10.0 + 0.0)
}

/// Coordinates of a point in pixels.
pub(super) fn write_point([x, y]: [f64; 2]) -> String {
    format!("{} {}", number(x), number(y))
}

/// A polyline through the points.
pub(super) fn line(places: &[[f64; 2]]) -> String {
    let mut text = String::new();
    for (i, &at) in places.iter().enumerate() {
        let _ = write!(text, "{}{}", if i == 0 { 'M' } else { 'L' }, write_point(at));
    }
    text
}

/// A path whose shape changes, with one shape for each frame.
pub(super) fn path(timeline: &Timeline, style: &str, forms: &[String], inside: &str) -> String {
    let moves = smooth(timeline, "d", forms);
    let end = if moves.is_empty() && inside.is_empty() { "/>" } else { ">" };
    let close = if end == ">" { "</path>" } else { "" };
    format!("<path d=\"{}\"{style}{end}{inside}{moves}{close}\n", forms[0])
}

/// An element that is translated, with one position for each frame.
pub(super) fn carried(timeline: &Timeline, places: &[String], element: &str) -> String {
    let moves = match same(places) {
        true => String::new(),
        false => format!(
            "<animateTransform attributeName=\"transform\" type=\"translate\"{}/>",
            values(timeline, places)
        ),
    };
    format!("<g transform=\"translate({})\">{element}{moves}</g>\n", places[0])
}

/// An attribute interpolated linearly between frames; empty if it is constant.
pub(super) fn smooth(timeline: &Timeline, attribute: &str, all: &[String]) -> String {
    match same(all) {
        true => String::new(),
        false => format!("<animate attributeName=\"{attribute}\"{}/>", values(timeline, all)),
    }
}

/// A piecewise constant attribute: its values, each with the fraction of the period from which it
/// holds; the first at 0.
pub(super) fn steps(timeline: &Timeline, attribute: &str, all: &[(f64, &str)]) -> String {
    let mut kept: Vec<(f64, &str)> = Vec::new();
    for &(key, value) in all {
        match kept.last() {
            Some(last) if last.1 == value => {}
            // Of simultaneous values the last counts.
            Some(last) if kept.len() > 1 && last.0 >= key => {
                kept.pop();
                kept.push((key, value));
            }
            _ => kept.push((key, value)),
        }
    }
    if kept.len() < 2 {
        return String::new();
    }
    let [values, keys] = [
        kept.iter().map(|(_, value)| (*value).to_owned()).collect::<Vec<_>>().join(";"),
        kept.iter().map(|(at, _)| key(*at)).collect::<Vec<_>>().join(";"),
    ];
    format!(
        "<animate attributeName=\"{attribute}\" calcMode=\"discrete\" values=\"{values}\" keyTimes=\"{keys}\"{}/>",
        forever(timeline)
    )
}

/// Values of all frames, the last repeated for the end of the period. Of a run of equal values only
/// the first and the last are kept.
fn values(timeline: &Timeline, all: &[String]) -> String {
    let moves = |i: usize| i == 0 || i + 1 == all.len() || all[i - 1] != all[i] || all[i] != all[i + 1];
    let kept: Vec<usize> = (0..all.len()).filter(|&i| moves(i)).collect();
    let values: String = kept.iter().map(|&i| all[i].clone() + ";").collect();
    let keys: String = kept.iter().map(|&i| key(timeline.key(timeline.times[i])) + ";").collect();
    let last = all.last().map_or("", String::as_str);
    format!(" values=\"{values}{last}\" keyTimes=\"{keys}1\"{}", forever(timeline))
}

fn forever(timeline: &Timeline) -> String {
    format!(" dur=\"{}s\" repeatCount=\"indefinite\"", (1e6 * timeline.period()).round() / 1e6)
}

/// A fraction of the period to four decimals.
fn key(part: f64) -> String {
    let text = format!("{part:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text.strip_prefix('0') {
        Some("") => "0".into(),
        Some(rest) => rest.into(),
        None => text.into(),
    }
}

fn same(all: &[String]) -> bool {
    all.iter().all(|value| *value == all[0])
}

/// The mean of points.
pub(super) fn mean(places: &[Px]) -> Px {
    match places {
        [a, b] => middle(*a, *b),
        _ => places.iter().fold([0.0; 2], |sum, &at| along(sum, at, 1.0 / places.len() as f64)),
    }
}
