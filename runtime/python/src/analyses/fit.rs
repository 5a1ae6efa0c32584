//! Parameters and starts from what was measured.

use super::beginning::Beginning;
use super::{answer, matrix};
use crate::errors::{self, in_python, invalid, warn};
use crate::options::Options;
use crate::values::{items, measured_as, numbers, texts};
use liftoff_core::model::Layout;
use liftoff_studio::analyses::{Measured, MeasuredEvent, MeasuredTable, describe_stop, fit as solve};
use liftoff_studio::registry::{Entry, Units};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict, PyTuple};
use std::path::PathBuf;

/// How a standard deviation is given.
const GIVES: &str =
    "`sd={column: value}`, a column `COLUMN ±`, or a pair (value, deviation) of an event gives it";

/// The values of parameters and entries of the start with the least sum of squares.
pub fn fit<'py>(
    py: Python<'py>,
    entry: &Entry,
    vary: &Bound<'py, PyAny>,
    start: Option<&Bound<'py, PyAny>>,
    mut options: Options<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let names = texts("vary", vary)?;
    let measured = take_measured(entry.layout(), &mut options)?;
    let mut beginning = Beginning::from_options(entry, start, &mut options)?;
    options.finish()?;
    measured.check(beginning.limit, GIVES).map_err(invalid)?;
    if measured.skipped > 0 {
        warn(py, &format!("empty cells, which are skipped: {}", measured.skipped))?;
    }
    let has_until = beginning.has_until;
    beginning.request.spec = measured.lengthen(beginning.request.spec, has_until);
    let found = beginning.search(py, |run| solve(entry, run, &names, &measured))?;
    let stopped = describe_stop(&found.ending);
    stopped.iter().try_for_each(|text| warn(py, text))?;
    let estimates = found.estimates.iter().map(|estimate| {
        let interval = estimate.interval.map(|[low, high]| (low, high));
        let told = answer(py, "Estimate", (estimate.value, estimate.standard_error, interval))?;
        Ok((estimate.name.clone(), told))
    });
    let estimates = estimates.collect::<PyResult<Vec<_>>>()?.into_py_dict(py)?;
    let size = found.correlations.len();
    let correlations = matrix(py, (size, size), |(i, k)| found.correlations[i][k]);
    let data: Vec<String> = measured.data.iter().map(ToString::to_string).collect();
    let fields = (
        estimates,
        correlations,
        data,
        found.residuals.into_pyarray(py),
        found.norm,
        found.freedom,
        found.scatter,
        found.runs,
        stopped,
    );
    answer(py, "Fit", fields)
}

/// What was measured: a table, and events.
fn take_measured(layout: &'static Layout, options: &mut Options<'_>) -> PyResult<Measured> {
    let mut all = Measured::default();
    let of = options.take("of")?.map_or(Ok(Vec::new()), |given| texts("of", &given))?;
    let units = Units::from_layout(layout);
    let deviations = options.take("sd")?.map_or(Ok(Vec::new()), |given| {
        let entries = items("sd", &given)?;
        let value = |(name, value): &(String, Bound<'_, PyAny>)| {
            Ok((name.clone(), measured_as(&units, name, (&format!("sd: {name}"), value))?))
        };
        entries.iter().map(value).collect::<PyResult<Vec<_>>>()
    })?;
    match options.take("data")? {
        Some(data) => {
            let table = table(layout, &data, &of)?;
            all.add_table(&table, &deviations).map_err(|why| invalid(format!("sd: {why}")))?;
            if all.last.is_none() {
                return Err(invalid("data: there are no values"));
            }
        }
        None if !of.is_empty() || !deviations.is_empty() => {
            return Err(invalid("of, sd: there is no data that they are about"));
        }
        None => {}
    }
    if let Some(events) = options.take("events")? {
        for (name, value) in items("events", &events)? {
            let what = format!("events: {name}");
            let event =
                MeasuredEvent::parse(&name, layout).map_err(|why| invalid(format!("{what}: {why}")))?;
            let kind = event.kind();
            let number = |value: &Bound<'_, PyAny>| measured_as(&units, &kind, (&what, value));
            let (value, deviation) = match value.cast::<PyTuple>() {
                Ok(pair) if pair.len() == 2 => {
                    (number(&pair.get_item(0)?)?, Some(number(&pair.get_item(1)?)?))
                }
                _ => (number(&value)?, None),
            };
            all.add_event(event, value, deviation).map_err(|why| invalid(format!("{what}: {why}")))?;
        }
    }
    Ok(all)
}

/// That of a file, or of columns by their names.
fn table(layout: &'static Layout, data: &Bound<'_, PyAny>, of: &[String]) -> PyResult<MeasuredTable> {
    if let Ok(path) = data.extract::<PathBuf>() {
        return MeasuredTable::load(layout, &path, of).map_err(errors::analysis);
    }
    // A frame is no mapping, and its times may be its index.
    let has_index = data.hasattr("reset_index")? && !data.contains("t")?;
    let data = if has_index { data.call_method0("reset_index")? } else { data.clone() };
    let is_frame = data.hasattr("keys")?;
    let data = if is_frame { data.py().get_type::<PyDict>().call1((data,))? } else { data };
    let mut columns = Vec::new();
    for (name, values) in items("data", &data)? {
        let wrong = |error: PyErr| invalid(format!("data: {name}: {}", error.value(data.py())));
        let values: Vec<f64> = numbers(&values).map_err(wrong)?.extract().map_err(wrong)?;
        columns.push((name, values));
    }
    let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    let rows = columns.first().map_or(0, |(_, values)| values.len());
    if let Some((name, values)) = columns.iter().find(|(_, values)| values.len() != rows) {
        let first = names[0];
        return Err(invalid(format!("data: {name} has {} values, but {first} has {rows}", values.len())));
    }
    let wrong = |why: String| invalid(format!("data: {}", in_python(&why)));
    let mut table = MeasuredTable::new(layout, &names, of).map_err(wrong)?;
    for row in 0..rows {
        // What is no number was not measured.
        let cell = |place: usize| Ok(Some(columns[place].1[row]).filter(|value| !value.is_nan()));
        table.push(row as u64, &cell).map_err(|why| invalid(format!("data, row {row}: {why}")))?;
    }
    Ok(table)
}
