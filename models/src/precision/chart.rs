//! Error against run time, drawn: both axes logarithmic, one panel for the final state and one for the events of each
//! system, our methods solid and other tools dashed.

use super::Row;
use crate::plot::{Axis, Chart, Curve, DrawingError, Ink, Sheet};

/// What a panel shows of a row.
type Quantity = fn(&Row) -> Option<f64>;

/// Width and height of a panel.
const PANEL: (u32, u32) = (860, 440);
const INKS: [Ink; 7] =
    [Ink::Blue, Ink::Vermilion, Ink::Green, Ink::Purple, Ink::Sky, Ink::Orange, Ink::Black];

/// The panels one below the other, as SVG.
pub fn sheet(rows: &[Row]) -> Result<String, DrawingError> {
    let charts = charts(rows);
    let (width, height) = PANEL;
    let description = "Error against run time, one point for each tolerance".into();
    Sheet { description, size: (width, height * charts.len().max(1) as u32) }.charts(&charts)
}

/// The panels of all systems; those without a point to show are left out.
pub fn charts(rows: &[Row]) -> Vec<Chart> {
    let quantities: [(&str, Quantity); 2] = [
        ("error of the final state", |row| row.state_error),
        ("error of event times", |row| row.event_error.filter(|error| *error > 0.0)),
    ];
    let mut charts = Vec::new();
    for model in distinct(rows, |row| &row.model) {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.model == model).collect();
        charts.extend(quantities.iter().filter_map(|(name, error)| panel(&rows, (model, name), error)));
    }
    charts
}

/// Half an ulp at least: an error of zero has no logarithm, and doubles tell no less.
fn panel(rows: &[&Row], (model, name): (&str, &str), error: &Quantity) -> Option<Chart> {
    let point = |row: &Row| Some([row.microseconds, error(row)?.max(f64::EPSILON / 2.0)]);
    let points: Vec<_> = rows.iter().filter_map(|row| point(row)).collect();
    let mut curves = Vec::new();
    for is_peer in [false, true] {
        let own: Vec<Row> =
            rows.iter().filter(|row| row.is_peer == is_peer).map(|row| (*row).clone()).collect();
        for (method, ink) in distinct(&own, |row| &row.method).into_iter().zip(INKS.into_iter().cycle()) {
            let points = own.iter().filter(|row| row.method == method).filter_map(point).collect();
            let curve = Curve::solid(method, ink, points).dotted();
            curves.push(if is_peer { curve.dashed() } else { curve });
        }
    }
    curves.retain(|curve| !curve.points.is_empty());
    let chart = Chart {
        x: Axis::decades(&format!("time of a run of {model}, µs"), points.iter().map(|point| point[0])),
        y: Axis::decades(name, points.iter().map(|point| point[1])),
        curves,
        marks: Vec::new(),
    };
    (!points.is_empty()).then_some(chart)
}

/// Names in the order in which they first occur.
fn distinct<'a>(rows: &'a [Row], name: impl Fn(&'a Row) -> &'a String) -> Vec<&'a str> {
    let mut names: Vec<&str> = Vec::new();
    for row in rows {
        if !names.contains(&name(row).as_str()) {
            names.push(name(row));
        }
    }
    names
}
