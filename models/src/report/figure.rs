//! A figure of the page, and the drawing of superposed positions that several share.

use super::ReportError;
use super::reading::places;
use crate::catalog::Record;
use crate::plot::{Ink, Stroke};

/// A drawing with its number and caption.
#[derive(Clone, Debug)]
pub struct Figure {
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
    record: &dyn Record,
    points: &[&str],
    times: &[f64],
    ink: Ink,
) -> Result<Vec<Stroke>, ReportError> {
    let last = times.len().saturating_sub(1).max(1) as f64;
    let stroke = |(i, &t): (usize, &f64)| {
        let opacity = 0.3 + 0.7 * i as f64 / last;
        Ok(Stroke { points: places(record, points, t)?, ink, opacity, width: 2 })
    };
    times.iter().enumerate().map(stroke).collect()
}

/// The path of a point over `[from, to]`.
pub fn path(record: &dyn Record, point: &str, interval: [f64; 2], ink: Ink) -> Result<Stroke, ReportError> {
    let outputs = [format!("x({point})"), format!("y({point})")];
    let points = super::reading::curve(record, [&outputs[0], &outputs[1]], interval, 200)?;
    Ok(Stroke { points, ink, opacity: 0.6, width: 1 })
}
