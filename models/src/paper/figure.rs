//! A figure of the page, and the drawing of superposed positions that several share.

use super::ReportError;
use super::reading::places;
use liftoff::Trajectory;
use liftoff_studio::picture::curve;
use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure, Mark, Stroke};

/// A drawing with its number and caption.
#[derive(Clone, Debug)]
pub struct CaptionedFigure {
    /// Its anchor on the page.
    pub anchor: &'static str,
    /// Its title, `Fig. 2`.
    pub title: &'static str,
    /// What it shows, as HTML.
    pub caption: String,
    /// The drawing.
    pub svg: String,
}

/// The bars through `points` at each of `times`, later ones stronger.
pub fn superposed(
    record: &Trajectory,
    points: &[&str],
    times: &[f64],
    colour: Colour,
) -> Result<Vec<Stroke>, ReportError> {
    let last = times.len().saturating_sub(1).max(1) as f64;
    let stroke = |(i, &t): (usize, &f64)| {
        let opacity = 0.3 + 0.7 * i as f64 / last;
        Ok(Stroke::solid(places(record, points, t)?, colour, opacity, 2))
    };
    times.iter().enumerate().map(stroke).collect()
}

/// The path of a point over `[from, to]`.
pub fn path(
    record: &Trajectory,
    point: &str,
    interval: [f64; 2],
    colour: Colour,
) -> Result<Stroke, ReportError> {
    let outputs = [format!("x({point})"), format!("y({point})")];
    let points = curve(record, [&outputs[0], &outputs[1]], interval)?;
    Ok(Stroke::solid(points, colour, 0.6, 1))
}

/// Outputs with their axes' names against the angle φ over an interval, one panel each, both ends
/// marked with these labels and the values there.
pub fn against_phi(
    record: &Trajectory,
    interval: [f64; 2],
    outputs: [(&str, &str); 2],
    ticks: &[f64],
    labels: [&str; 2],
) -> Result<String, ReportError> {
    let mut panels = Vec::new();
    for (name, output) in outputs {
        let points = curve(record, ["phi", output], interval)?;
        let [first, last] = [points[0], points[points.len() - 1]];
        let mark = |at: [f64; 2], name: &str| Mark { at, label: format!("{name}: {}", decimals(at[1], 3)) };
        let marks = vec![mark(first, labels[0]), mark(last, labels[1])];
        panels.push(Chart {
            x: Axis::linear("φ, rad", [first[0], last[0]]).with_ticks(ticks),
            y: Axis::holding(name, points.iter().map(|p| p[1])),
            marks,
            curves: vec![Curve::solid("", Colour::Blue, points)],
        });
    }
    let [(first, _), (second, _)] = outputs;
    let description = format!("{first} and {second} against the angle");
    Ok(Figure { description, size: (560, 480) }.charts(&panels))
}

/// A number with so many decimals and a real minus sign.
pub fn decimals(value: f64, count: usize) -> String {
    let text = format!("{value:.count$}");
    let is_zero = text.chars().all(|digit| matches!(digit, '-' | '0' | '.'));
    text.replace('-', if is_zero { "" } else { "−" })
}
