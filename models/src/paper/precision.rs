//! Error against run time of every method on both systems of the paper, and on those of other tools' rows.

use super::figure::Figure;
use super::{ReportError, falling_pair, strict};
use crate::models;
use liftoff::catalog::Asked;
use liftoff::plot::{Chart, Sheet};
use liftoff::scene::{Setup, named};
use liftoff::work_precision::{Row, charts, peers, rows};
use std::path::PathBuf;
use std::time::Duration;

/// Time for each method at each tolerance, so that the least of several runs is told.
const MEASURING: Duration = Duration::from_millis(3);
/// The scene that other tools run beside the falling pair.
const PENDULUM: &str = "double-pendulum";

/// Measures both systems, and the double pendulum where other tools tell of it; their rows follow.
pub fn measure(files: &[PathBuf]) -> Result<Vec<Row>, ReportError> {
    let mut others = Vec::new();
    for file in files {
        others.extend(peers(file)?);
    }
    let asked = Asked { measuring: MEASURING, ..Asked::default() };
    let mut all = rows(
        models().find(falling_pair::MODEL)?,
        &falling(models().find(falling_pair::MODEL)?.setup()),
        &asked,
    )?;
    all.extend(rows(models().find(strict::MODEL)?, &strict::setup(0.5, 1e-12)?, &asked)?);
    if others.iter().any(|row| row.model == PENDULUM) {
        let model = models().find(PENDULUM)?;
        all.extend(rows(model, &swinging(model.setup()), &asked)?);
    }
    all.extend(others);
    Ok(all)
}

/// From rest at φ = 0.1, as other tools run it.
fn falling(setup: Setup) -> Setup {
    Setup { start: named(&[("phi", 0.1)]), energy_of: Vec::new(), ..setup }
}

/// From rest at (2, 1) for 10 s.
fn swinging(setup: Setup) -> Setup {
    Setup { start: named(&[("phi_1", 2.0), ("phi_2", 1.0)]), until: vec!["t = 10".into()], ..setup }
}

/// The rows as log–log charts, a figure for each panel.
pub fn figures(rows: &[Row]) -> Result<Vec<Figure>, ReportError> {
    charts(rows).into_iter().enumerate().map(|(i, chart)| figure(chart, i == 0)).collect()
}

fn figure(chart: Chart, first: bool) -> Result<Figure, ReportError> {
    let description = format!("{} against {}, tolerances from 1e-3 to 1e-14", chart.y.name, chart.x.name);
    let caption = if first {
        "One point for each tolerance 10⁻³ … 10⁻¹⁴, the least time of several runs that record nothing but their events; \
         errors against a run in double-double by extrapolation. Dashed: other tools."
    } else {
        "The same runs, or the next system's."
    };
    Ok(Figure {
        anchor: if first { "precision" } else { "" },
        title: "Error against run time",
        caption: caption.into(),
        svg: Sheet { description, size: (860, 440) }.charts(&[chart])?,
    })
}
