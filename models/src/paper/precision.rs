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
        "All methods at the tolerances {}; stiff-spring by {}. Time: the least of up to eight rounds in which they take turns{}, of runs \
         that record nothing but their events. Errors: the largest deviation of a coordinate or rate in natural units of the \
         model (the length of the longest bar, or without bars the largest length among the coordinates of the start; the time \
         √(l/g)), angles in radians, at the end, and over the run: there and, by dense output, in the middles of 32 equal parts; \
         of events, the largest deviation of a time in natural times √(l/g). Against a motion in double-double; of \
         stiff-spring, two masses that swing on a soft spring, joined by an undamped one 10¹⁰ times as stiff, against its closed form.",
        describe_range(&PrecisionSpec::default().tolerances),
        describe_request(&stiff::request(MEASURING)),
        machine()
    )
}

/// `auto and radau at 10⁻³ … 10⁻¹⁰`.
fn describe_request(spec: &PrecisionSpec) -> String {
    let methods: Vec<_> = spec.methods.iter().map(|method| method.name()).collect();
    format!("{} at {}", methods.join(" and "), describe_range(&spec.tolerances))
}

/// Tolerances that are powers of ten: `10⁻³ … 10⁻¹⁴`.
fn describe_range(tolerances: &[f64]) -> String {
    let digit = |c: char| c.to_digit(10).and_then(|k| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(k as usize));
    let power = |tolerance: &f64| {
        let exponent = format!("{:.0}", -tolerance.log10());
        format!("10⁻{}", exponent.chars().filter_map(digit).collect::<String>())
    };
    let ends = [tolerances.first(), tolerances.last()];
    ends.into_iter().flatten().map(power).collect::<Vec<_>>().join(" … ")
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tolerances_of_every_scene_are_reported() {
        let text = explain_norm();
        assert!(text.starts_with(
            "All methods at the tolerances 10⁻³ … 10⁻¹⁴; stiff-spring by auto and radau at 10⁻³ … 10⁻¹⁰."
        ));
    }
}
