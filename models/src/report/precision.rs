//! Error against run time over tolerances, on both systems of the paper, against references that the
//! integrator had no part in.

use super::quantity::{Quantity, Value, error};
use super::reference::References;
use super::{ReportError, falling_pair, strict};
use crate::catalog::{Model, find};
use crate::plot::{Axis, Chart, Curve, Ink, Sheet};
use crate::report::figure::Figure;
use crate::scene::Setup;
use std::time::{Duration, Instant};

/// Time spent on measuring one point at least, so that the least of several times is told.
const MEASURING: Duration = Duration::from_millis(30);

/// One tolerance on one system.
#[derive(Clone, PartialEq, Debug)]
pub struct Point {
    /// Relative tolerance asked for.
    pub tolerance: f64,
    /// Least wall time of a run, s.
    pub seconds: f64,
    /// Largest relative error of the system's quantities.
    pub error: f64,
    /// Accepted steps.
    pub steps: u64,
    /// Evaluations of the equations.
    pub evaluations: u64,
}

/// The points of one system.
#[derive(Clone, PartialEq, Debug)]
pub struct Series {
    /// The system.
    pub name: &'static str,
    /// From coarse to fine; tolerances at which a quantity was missed are left out.
    pub points: Vec<Point>,
}

/// Tolerances from 1e-3 to 1e-14.
fn tolerances() -> impl Iterator<Item = f64> {
    (3..=14).map(|digits| 10f64.powi(-digits))
}

/// Measures both systems.
pub fn measure(tables: &References) -> Result<Vec<Series>, ReportError> {
    let pair = |tolerance: f64| -> Result<_, ReportError> {
        let model = find(falling_pair::MODEL)?;
        Ok((model, model.setup().tolerance(tolerance)))
    };
    let zigzag = |tolerance: f64| -> Result<_, ReportError> {
        Ok((find(strict::MODEL)?, strict::setup(0.5, tolerance)?))
    };
    Ok(vec![
        series("Fig. 1a", tables, pair, |t| falling_pair::Runs::new(t)?.quantities())?,
        series("Fig. 1b strict, λ = 0.5", tables, zigzag, |t| {
            Ok(strict::Run::new(("0.50", 0.5), t)?.quantities())
        })?,
    ])
}

fn series(
    name: &'static str,
    tables: &References,
    run: impl Fn(f64) -> Result<(&'static dyn Model, Setup), ReportError>,
    quantities: impl Fn(f64) -> Result<Vec<Quantity>, ReportError>,
) -> Result<Series, ReportError> {
    let mut points = Vec::new();
    for tolerance in tolerances() {
        let Some(error) = quantities(tolerance).ok().and_then(|all| largest_error(&all, tables)) else {
            continue;
        };
        let (model, setup) = run(tolerance)?;
        let statistics = model.run(&setup)?.statistics();
        points.push(Point {
            tolerance,
            seconds: least_time(model, &setup)?,
            error,
            steps: statistics.steps,
            evaluations: statistics.evaluations,
        });
    }
    Ok(Series { name, points })
}

/// None where a quantity with a reference is missing.
fn largest_error(quantities: &[Quantity], tables: &References) -> Option<f64> {
    let mut largest = 0.0_f64;
    for quantity in quantities {
        let Some(reference) = tables.reference(&quantity.id) else {
            continue;
        };
        match (quantity.computed.as_ref()?, reference.value.parse()) {
            (Value::Number(computed), Ok(reference)) => largest = largest.max(error(*computed, reference)),
            (Value::Supports(supports), _) if *supports == reference.value => {}
            _ => return None,
        }
    }
    Some(largest)
}

fn least_time(model: &dyn Model, setup: &Setup) -> Result<f64, ReportError> {
    let begun = Instant::now();
    let mut least = f64::INFINITY;
    while begun.elapsed() < MEASURING || least.is_infinite() {
        let start = Instant::now();
        std::hint::black_box(model.run(setup)?);
        least = least.min(start.elapsed().as_secs_f64());
    }
    Ok(least)
}

/// The points as a log–log chart.
pub fn figure(series: &[Series]) -> Result<Figure, ReportError> {
    let points = || series.iter().flat_map(|series| &series.points);
    // An error of zero has no logarithm: half an ulp is as good as doubles tell.
    let shown = |error: f64| error.max(f64::EPSILON / 2.0);
    let inks = [Ink::Blue, Ink::Vermilion];
    let line = |(series, ink): (&Series, Ink)| {
        let points = series.points.iter().map(|point| [point.seconds * 1e3, shown(point.error)]);
        Curve::solid(series.name, ink, points.collect()).dotted()
    };
    let chart = Chart {
        x: Axis::decades("run time, ms", points().map(|point| point.seconds * 1e3)),
        y: Axis::decades("largest relative error", points().map(|point| shown(point.error))),
        curves: series.iter().zip(inks).map(line).collect(),
        marks: Vec::new(),
    };
    let description = "Largest relative error against run time, tolerances from 1e-3 to 1e-14";
    Ok(Figure {
        anchor: "precision",
        title: "Error against run time",
        caption: "DOP853 at tolerances 10⁻³ … 10⁻¹⁴ (one point each, the finer the slower): largest error of the system's \
                  quantities relative to the references, against the time of one run, events located."
            .into(),
        svg: Sheet { description: description.into(), size: (860, 440) }.charts(&[chart])?,
    })
}
