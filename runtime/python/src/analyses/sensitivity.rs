//! Derivatives of a run.

use super::answer;
use super::beginning::Beginning;
use crate::event::Event;
use crate::options::Options;
use crate::values::texts;
use liftoff_studio::analyses::{DifferentiatedRun, differentiate};
use liftoff_studio::registry::Entry;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

/// The derivatives of a run with respect to parameters and entries of its start.
pub fn sensitivities<'py>(
    py: Python<'py>,
    entry: &Entry,
    of: Option<&Bound<'py, PyAny>>,
    start: Option<&Bound<'py, PyAny>>,
    mut options: Options<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let of = of.map_or(Ok(Vec::new()), |given| texts("of", given))?;
    let beginning = Beginning::from_options(entry, start, &mut options)?;
    options.finish()?;
    let found = beginning.search(py, |(options, spec)| differentiate(entry, options, &spec, &of))?;
    found.left_out.iter().try_for_each(|text| crate::errors::warn(py, text))?;
    let DifferentiatedRun { run, variables, sensitivities, .. } = &found;
    let by_variable = |slopes: &[f64]| -> PyResult<Bound<'py, PyDict>> {
        variables.iter().map(|of| &of.name).zip(slopes.iter().copied()).into_py_dict(py)
    };
    let by_entry = |rows: &[Vec<f64>]| -> PyResult<Bound<'py, PyDict>> {
        let rows: PyResult<Vec<_>> = rows.iter().map(|row| by_variable(row)).collect();
        run.layout().names_of_state().zip(rows?).into_py_dict(py)
    };
    let events = run.events().iter().zip(&sensitivities.events).map(|(event, derivatives)| {
        let time = derivatives.time.as_ref().map(|time| by_variable(time)).transpose()?;
        let state = by_entry(&derivatives.state)?;
        answer(py, "EventDerivatives", (Event::from_event(event, run), time, state))
    });
    answer(py, "Sensitivities", (events.collect::<PyResult<Vec<_>>>()?, by_entry(&sensitivities.end)?))
}
