//! Which support opens first, over λ and the start.

use super::MODEL;
use crate::models;
use crate::paper::ReportError;
use crate::paper::figure::CaptionedFigure;
use liftoff_studio::RunSpec;
use liftoff_studio::sweep::{Sweep, SweepError};

/// The map, from runs at rest with all angles φ(0).
pub fn figure(tolerance: f64) -> Result<CaptionedFigure, ReportError> {
    let table = sweep(tolerance).map_err(|error| ReportError::Sweep(error.to_string()))?;
    Ok(CaptionedFigure {
        anchor: "map",
        title: "Fig. 1b strict: which support opens first",
        caption: format!(
            "{} runs from rest, all angles φ(0): below λ = ¼ the outer feet A and E open first, above it C, and all at once on \
             the line between; none where the bars start too low.",
            table.0
        ),
        svg: table.1,
    })
}

/// How many runs, and their map.
fn sweep(tolerance: f64) -> Result<(usize, String), SweepError> {
    let spec = RunSpec::with(&[("l", 1.0), ("g", 1.0)]).tolerance(tolerance);
    let model = models().find(MODEL).map_err(|error| SweepError::Invalid(error.to_string()))?;
    let sweep = Sweep::of(model)
        .spec(spec)
        .vary("lambda=0.01:0.99:99")?
        .vary("phi0=0.3:1.55:51")?
        .set("m1=1-lambda")?
        .set("m2=lambda")?
        .start("phi_inner=phi0")?
        .start("phi_outer=phi0")?
        .observe("first open")?;
    let table = sweep.run()?;
    Ok((table.rows.len(), table.svg()?))
}
