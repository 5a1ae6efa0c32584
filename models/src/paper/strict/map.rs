//! Which support opens first, over λ and the start.

use super::MODEL;
use crate::models;
use crate::paper::ReportError;
use crate::paper::figure::{CaptionedFigure, decimals};
use liftoff_studio::RunSpec;
use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure, Mark};
use liftoff_studio::sweep::{Boundary, Sweep};

/// How closely the curves are followed, in parts of the ranges.
const WIDTH: f64 = 1e-7;

/// The curves between first openings, from rest with all angles φ(0).
pub fn figure(tolerance: f64) -> Result<CaptionedFigure, ReportError> {
    let spec = RunSpec::with(&[("l", 1.0), ("g", 1.0)]).tolerance(tolerance);
    let curves = Sweep::new(models().find(MODEL)?)
        .spec(spec)
        .vary("lambda=0.01:0.99:5")?
        .vary("phi0=0.2:1.55:5")?
        .set("m1=1-lambda")?
        .set("m2=lambda")?
        .start("phi_inner=phi0")?
        .start("phi_outer=phi0")?
        .observe("first open")?
        .boundaries(WIDTH)?;
    let corner = curves.iter().filter(|curve| parts(curve, "A, E", "C")).flat_map(|curve| &curve.points);
    let corner = corner.min_by(|a, b| a[1].total_cmp(&b[1])).copied();
    let text = |[ratio, phi]: [f64; 2]| format!("λ = {}, φ(0) = {}", decimals(ratio, 4), decimals(phi, 4));
    let chart = Chart {
        x: Axis::linear("λ", [0.0, 1.0]),
        y: Axis::linear("φ(0), rad", [0.2, 1.6]),
        curves: curves.iter().map(drawn).collect(),
        marks: corner.map(|at| Mark { at, label: text(at) }).into_iter().collect(),
    };
    let sheet = Figure { description: "Which support opens first".into(), size: (560, 480) };
    Ok(CaptionedFigure {
        anchor: "map",
        title: "Fig. 1b strict: which support opens first",
        caption: "From rest, all angles φ(0): left of the upright line, at λ = ¼, the outer feet A and E open first, right of it C, \
                  on it all at once; below the other two lines none does before the bars lie level."
            .into(),
        svg: sheet.charts(&[chart]),
    })
}

/// Whether a curve is between these two outcomes.
fn parts(curve: &Boundary, one: &str, other: &str) -> bool {
    [(one, other), (other, one)].contains(&(curve.left.as_str(), curve.right.as_str()))
}

/// A curve in the colour of what opens first above it.
fn drawn(curve: &Boundary) -> Curve {
    let (name, colour) = match () {
        () if parts(curve, "none", "C") => ("C opens first above it", Colour::Vermilion),
        () if parts(curve, "none", "A, E") => ("A and E open first above it", Colour::Green),
        () => ("A, C, E open at once", Colour::Blue),
    };
    Curve::solid(name, colour, curve.points.clone())
}
