//! Error against run time and against evaluations, drawn: all axes logarithmic, panels for the
//! states over the run, the final state and the events of each system, our methods solid and other
//! tools dashed.

use super::WorkPrecisionRow;
use crate::plot::{Axis, Chart, Colour, Curve, Figure};

/// What a panel shows of a row.
type Quantity = fn(&WorkPrecisionRow) -> Option<f64>;

/// Width and height of a panel.
const PANEL: (u32, u32) = (860, 440);
/// The panels one below the other, as SVG.
pub fn figure(rows: &[WorkPrecisionRow]) -> String {
    figure_so_wide(rows, None)
}

/// The same, so many pixels wide.
pub fn figure_so_wide(rows: &[WorkPrecisionRow], width: Option<u32>) -> String {
    let charts = charts(rows);
    let (own, height) = PANEL;
    let width = width.unwrap_or(own);
    let description = "Error against run time, one point for each tolerance".into();
    Figure { description, size: (width, height * charts.len().max(1) as u32) }.charts(&charts)
}

/// The panels of all systems; those without a point to show are left out. A method has one colour
/// in all of them.
pub fn charts(rows: &[WorkPrecisionRow]) -> Vec<Chart> {
    let run = ("largest error over the run", (|row| row.run_error) as Quantity);
    let state = ("error of the final state", (|row| row.state_error) as Quantity);
    let events = ("error of event times", (|row| row.event_error.filter(|error| *error > 0.0)) as Quantity);
    let time = ("time of a run of", "µs", (|row| Some(row.microseconds)) as Quantity);
    let evaluations = (
        "evaluations of the right-hand side of",
        "",
        (|row| row.evaluations.map(|it| it as f64)) as Quantity,
    );
    let diagrams = [(time, run), (evaluations, run), (time, state), (time, events)];
    let methods = [false, true].map(|is_peer| {
        let names = distinct(rows.iter().filter(|row| row.is_peer == is_peer).map(|row| &row.method));
        let colours = Colour::CURVES.into_iter().chain([Colour::Black]).cycle();
        names.into_iter().zip(colours).map(move |(name, colour)| Line { name, colour, is_peer })
    });
    let lines: Vec<Line> = methods.into_iter().flatten().collect();
    let mut charts = Vec::new();
    for model in distinct(rows.iter().map(|row| &row.model)) {
        let rows: Vec<&WorkPrecisionRow> = rows.iter().filter(|row| row.model == model).collect();
        for ((work, unit, cost), (name, error)) in diagrams {
            let x = format!("{work} {model}{}{unit}", if unit.is_empty() { "" } else { ", " });
            charts.extend(panel(&rows, &lines, [&x, name], [cost, error]));
        }
    }
    charts
}

/// How a method is drawn.
struct Line<'a> {
    name: &'a str,
    colour: Colour,
    is_peer: bool,
}

/// Half an ulp at least: an error of zero has no logarithm, and doubles tell no less.
fn panel(
    rows: &[&WorkPrecisionRow],
    lines: &[Line],
    [x, y]: [&str; 2],
    [cost, error]: [Quantity; 2],
) -> Option<Chart> {
    let point = |row: &&WorkPrecisionRow| {
        Some([cost(row).filter(|cost| *cost > 0.0)?, error(row)?.max(f64::EPSILON / 2.0)])
    };
    let curve = |line: &Line| {
        let own = rows.iter().filter(|row| row.method == line.name && row.is_peer == line.is_peer);
        let curve = Curve::solid(line.name, line.colour, own.filter_map(point).collect()).dotted();
        if line.is_peer { curve.dashed() } else { curve }
    };
    let curves: Vec<Curve> = lines.iter().map(curve).filter(|curve| !curve.points.is_empty()).collect();
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let chart = Chart {
        x: Axis::decades(x, points().map(|point| point[0])),
        y: Axis::decades(y, points().map(|point| point[1])),
        curves: curves.clone(),
        marks: Vec::new(),
    };
    (!curves.is_empty()).then_some(chart)
}

/// Names in the order in which they first occur.
fn distinct<'a>(all: impl Iterator<Item = &'a String>) -> Vec<&'a str> {
    let mut names: Vec<&str> = Vec::new();
    for name in all {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::Dash;

    #[test]
    fn a_tool_keeps_its_colour_where_another_has_no_events() {
        let row = |tool, errors| WorkPrecisionRow::peer(("pair", tool, 1e-6), errors, 10.0);
        let rows = [row("smooth", [Some(1e-6), None]), row("other", [Some(1e-7), Some(1e-8)])];
        let charts = charts(&rows);
        assert_eq!(charts.len(), 2);
        assert_eq!((charts[0].curves.len(), charts[1].curves.len()), (2, 1));
        assert_eq!(charts[0].curves[1].colour, charts[1].curves[0].colour);
        assert_eq!(charts[1].curves[0].dash, Dash::Dashed);
    }
}
