//! Pictures and pages of a motion, and how Python holds them.

use crate::errors;
use liftoff::Trajectory;
use liftoff_studio::animation::{About, page};
use liftoff_studio::picture::{ChartNumbers, Charts};
use liftoff_studio::registry::MotionError;
use pyo3::prelude::*;

/// The chart of outputs against time, or another output.
pub fn chart(run: &Trajectory, outputs: &[String], against: &str) -> Result<String, MotionError> {
    Charts::new(run).outputs(outputs).against(against).svg()
}

/// The same as numbers.
pub fn numbers(run: &Trajectory, outputs: &[String], against: &str) -> Result<ChartNumbers, MotionError> {
    Charts::new(run).outputs(outputs).against(against).numbers()
}

/// The page that plays a motion.
pub fn playing(run: &Trajectory, outputs: &[String], stopped: Option<&str>) -> Result<String, MotionError> {
    let layout = run.layout();
    let names = layout.parameters.iter().map(|name| (*name).to_owned());
    let parameters: Vec<(String, f64)> = names.zip(run.parameters().iter().copied()).collect();
    let about =
        About { title: layout.name, summary: layout.summary, parameters: &parameters, outputs, stopped };
    page(run, &about)
}

/// Refuses outputs that the model does not have.
pub fn check(run: &Trajectory, outputs: &[String]) -> PyResult<()> {
    outputs.iter().try_for_each(|text| run.output(text).map(drop).map_err(|error| errors::expression(&error)))
}

/// A picture that a notebook shows.
pub fn svg(py: Python<'_>, text: String) -> PyResult<Bound<'_, PyAny>> {
    py.import("liftoff._show")?.getattr("Svg")?.call1((text,))
}

/// A page that a notebook shows.
pub fn html(py: Python<'_>, text: String) -> PyResult<Bound<'_, PyAny>> {
    py.import("liftoff._show")?.getattr("Page")?.call1((text,))
}
