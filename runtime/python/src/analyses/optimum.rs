//! Parameters and starts with which an output is least or greatest.

use super::answer;
use super::beginning::Beginning;
use crate::errors::{invalid, warn};
use crate::options::Options;
use crate::values::{items, measured_as, texts};
use liftoff_core::model::Layout;
use liftoff_studio::analyses::{Bounded, Goal, describe_stop, optimise as solve};
use liftoff_studio::registry::{Entry, Units};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyMapping};

/// The values with which an output is least or greatest.
pub fn optimise<'py>(
    py: Python<'py>,
    entry: &Entry,
    (of, vary): (&str, &Bound<'py, PyAny>),
    start: Option<&Bound<'py, PyAny>>,
    mut options: Options<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let layout = entry.layout();
    let varied = bounded(layout, vary)?;
    let greatest = options.take("greatest")?.map_or(Ok(false), |given| given.extract())?;
    let goal = Goal::parse(of, layout, greatest).map_err(|why| invalid(format!("of: `{of}`: {why}")))?;
    let beginning = Beginning::from_options(entry, start, &mut options)?;
    options.finish()?;
    let best = beginning.search(py, |run| solve(entry, run, &varied, goal))?;
    let stopped = describe_stop(&best.ending);
    stopped.iter().try_for_each(|text| warn(py, text))?;
    let names = || varied.iter().map(|(name, _)| name);
    let values = names().zip(best.values.iter().copied()).into_py_dict(py)?;
    let slopes = names().zip(best.slopes.iter().copied()).into_py_dict(py)?;
    let at_bounds = names().zip(&best.at_bounds).filter(|(_, is_at)| **is_at).map(|(name, _)| name);
    let at_bounds: Vec<&String> = at_bounds.collect();
    answer(py, "Optimum", (best.value, values, slopes, at_bounds, best.first, best.runs, stopped))
}

/// Names, or a dict of names and bounds.
fn bounded(layout: &'static Layout, vary: &Bound<'_, PyAny>) -> PyResult<Vec<Bounded>> {
    if vary.cast::<PyMapping>().is_err() {
        return Ok(texts("vary", vary)?.into_iter().map(|name| (name, None)).collect());
    }
    let units = Units::from_layout(layout);
    let bounds = |(name, bounds): (String, Bound<'_, PyAny>)| {
        let what = format!("vary: {name}");
        if bounds.is_none() {
            return Ok((name, None));
        }
        let given: Result<(Bound<'_, PyAny>, Bound<'_, PyAny>), _> = bounds.extract();
        let wrong = || invalid(format!("{what}: expected a lower and a greater bound, or None"));
        let (low, high) = given.map_err(|_| wrong())?;
        let [low, high] = [low, high].map(|value| measured_as(&units, &name, (&what, &value)));
        let (low, high) = (low?, high?);
        match low < high && (high - low).is_finite() {
            true => Ok((name, Some([low, high]))),
            false => Err(wrong()),
        }
    };
    items("vary", vary)?.into_iter().map(bounds).collect()
}
