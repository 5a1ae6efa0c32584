//! Draws the rows as `chain.svg`.

use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure};
use serde_json::{Map, Value};

use crate::{Result, output};

const PANEL: (u32, u32) = (860, 420);

/// A key of the rows, with the label of its axis.
const QUANTITIES: [(&str, &str); 4] = [
    ("ns", "time of a right-hand side, ns"),
    ("code_bytes", "machine code, bytes"),
    ("rustc_ms", "time of rustc, ms"),
    ("expand_ms", "time of the macro, ms"),
];

const VARIANTS: [(&str, Colour); 3] =
    [("generated", Colour::Blue), ("hand-ldl", Colour::Vermilion), ("hand-recursion", Colour::Green)];

/// Draws the available sections.
pub fn draw(sections: &Map<String, Value>) -> Result<()> {
    let Some(rows) = sections.get("chain").and_then(Value::as_array) else { return Ok(()) };
    let panels: Vec<Chart> = QUANTITIES.iter().filter_map(|quantity| panel(rows, *quantity)).collect();
    let (width, height) = PANEL;
    let description = "Right-hand sides of a chain of n bars, generated and by hand".into();
    let sheet = Figure { description, size: (width, height * panels.len().max(1) as u32) };
    Ok(std::fs::write(output::folder()?.join("chain.svg"), sheet.charts(&panels))?)
}

fn panel(rows: &[Value], (key, name): (&str, &str)) -> Option<Chart> {
    let curve = |&(variant, colour): &(&str, Colour)| {
        let own = rows.iter().filter(|row| row["variant"] == variant);
        let points = own.filter_map(|row| Some([row["n"].as_f64()?, row[key].as_f64()?]));
        Curve::solid(variant, colour, points.collect()).dotted()
    };
    let curves: Vec<Curve> = VARIANTS.iter().map(curve).filter(|curve| !curve.points.is_empty()).collect();
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let chart = Chart {
        x: Axis::decades("bars", points().map(|point| point[0])),
        y: Axis::decades(name, points().map(|point| point[1])),
        curves: curves.clone(),
        marks: Vec::new(),
    };
    (!curves.is_empty()).then_some(chart)
}
