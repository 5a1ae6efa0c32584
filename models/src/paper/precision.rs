//! Error against run time of every method on both systems of the paper, on a stiff spring, and on
//! those of other tools' rows.

use super::figure::CaptionedFigure;
use super::{ReportError, falling_pair, stiff, strict};
use crate::models;
use liftoff_studio::plot::{Chart, Figure};
use liftoff_studio::registry::PrecisionSpec;
use liftoff_studio::run_spec::{RunSpec, named};
use liftoff_studio::work_precision::{WorkPrecisionRow, charts, peers, rows};
use std::path::PathBuf;
use std::time::Duration;

/// Time for each method at each tolerance, in eight rounds.
const MEASURING: Duration = Duration::from_millis(1);
/// The scene that other tools run beside the falling pair.
const PENDULUM: &str = "double-pendulum";

/// Measures both systems, and the double pendulum where other tools tell of it; their rows follow.
pub fn measure(files: &[PathBuf]) -> Result<Vec<WorkPrecisionRow>, ReportError> {
    let mut others = Vec::new();
    for file in files {
        others.extend(peers(file)?);
    }
    let request = PrecisionSpec { measuring: MEASURING, ..PrecisionSpec::default() };
    let mut all = rows(
        models().find(falling_pair::MODEL)?,
        &falling(models().find(falling_pair::MODEL)?.default_run()),
        &request,
    )?;
    all.extend(rows(models().find(strict::MODEL)?, &strict::spec(0.5, 1e-12)?, &request)?);
    all.extend(stiff::measure(MEASURING)?);
    if others.iter().any(|row| row.model == PENDULUM) {
        let model = models().find(PENDULUM)?;
        all.extend(rows(model, &swinging(model.default_run()), &request)?);
    }
    all.extend(others);
    Ok(all)
}

/// From rest at φ = 0.1, as other tools run it.
fn falling(spec: RunSpec) -> RunSpec {
    RunSpec { start: named(&[("phi", 0.1)]), energy_of: Vec::new(), ..spec }
}

/// From rest at (2, 1) for 10 s.
fn swinging(spec: RunSpec) -> RunSpec {
    RunSpec { start: named(&[("phi_1", 2.0), ("phi_2", 1.0)]), until: vec!["t = 10".into()], ..spec }
}

/// The rows as log–log charts, a figure for each panel.
pub fn figures(rows: &[WorkPrecisionRow]) -> Vec<CaptionedFigure> {
    charts(rows).into_iter().enumerate().map(|(i, chart)| figure(chart, i == 0)).collect()
}

/// What is measured, said once for all figures.
pub fn explain_norm() -> String {
    format!(
        "All methods at the tolerances 10⁻³ … 10⁻¹⁴. Time: the least of up to eight rounds in which they take turns{}, of runs \
         that record nothing but their events. Errors: the largest deviation of a coordinate or rate in natural units of the \
         model, angles in radians, at the end, and over the run: there and, by dense output, in the middles of 32 equal parts; \
         of events, the largest deviation of a time in natural times √(l/g). Against a motion in double-double; of \
         stiff-spring, two masses that swing on a soft spring, joined by an undamped one 10¹⁰ times as stiff, against its closed form.",
        machine()
    )
}

fn figure(chart: Chart, first: bool) -> CaptionedFigure {
    CaptionedFigure {
        anchor: if first { "precision" } else { "" },
        title: match chart.x.name.starts_with("time") {
            true => "Error against run time",
            false => "Error against evaluations",
        },
        caption: format!("The {} against the {}.", chart.y.name, chart.x.name),
        svg: Figure { description: format!("{} against {}", chart.y.name, chart.x.name), size: (860, 440) }
            .charts(&[chart]),
    }
}

/// The processor, where the system tells it.
fn machine() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = told.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(String::new, |(_, name)| format!(", on one core of {}", name.trim()))
}
