//! Curves across which what is observed changes.

use super::given::Given;
use super::{prepared, threads};
use crate::analyses::answer;
use crate::errors::{self, in_python, invalid};
use crate::interrupt::watched;
use crate::options::Options;
use crate::values::{items, number};
use liftoff_studio::registry::Entry;
use liftoff_studio::sweep::{Boundary, SweepError, Varied};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

/// How closely a curve is known, in parts of the ranges.
const ACCURACY: f64 = 1e-10;

/// The curves in the plane of two names.
pub fn boundaries<'py>(
    py: Python<'py>,
    entry: &Entry,
    vary: &Bound<'py, PyAny>,
    options: Option<Bound<'py, PyDict>>,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let mut options = Options::new("boundary", options).beside(&["vary"]);
    let varied = ranges(vary)?;
    let names: Vec<String> = varied.iter().map(|varied| varied.name.clone()).collect();
    let observe = options.take("observe")?.map_or(Ok("first open".to_owned()), |given| given.extract())?;
    let accuracy = options.take("accuracy")?.map(|given| number("accuracy", &given)).transpose()?;
    let accuracy = accuracy.map_or(ACCURACY, |(value, _)| value);
    let threads = threads(&mut options)?;
    let given = Given::take(entry, &mut options)?;
    options.finish()?;
    if let Some((name, _)) = given.arrays.first() {
        return Err(invalid(format!(
            "{name}: an array; a boundary lies in the plane of the ranges in `vary`"
        )));
    }
    let wrong = |error: SweepError| errors::sweep(&error);
    let sweep = prepared(entry, given, varied, &[observe]).map_err(wrong)?.threads(threads);
    let curves = watched(py, |stop| sweep.cancel(stop).boundaries(accuracy))?.map_err(wrong)?;
    let curve = |curve: Boundary| {
        let column =
            |k: usize| curve.points.iter().map(|point| point[k]).collect::<Vec<_>>().into_pyarray(py);
        let points = names.iter().zip([column(0), column(1)]).into_py_dict(py)?;
        let [first, last] = curve.ends.map(|end| end.to_string());
        answer(py, "Boundary", (curve.left, curve.right, points, (first, last)))
    };
    curves.into_iter().map(curve).collect()
}

/// Two names with their ranges: `(low, high)`, or `(low, high, count)`.
fn ranges(vary: &Bound<'_, PyAny>) -> PyResult<Vec<Varied>> {
    let range = |(name, ends): (String, Bound<'_, PyAny>)| {
        let wrong = |why: &dyn ToString| invalid(format!("vary: {name}: {}", in_python(&why.to_string())));
        let expected = || wrong(&"expected a pair of numbers, or three with the size of the grid");
        let parts = ends.try_iter().map_err(|_| expected())?.map(|part| Ok(part?.str()?.to_string()));
        let parts = parts.collect::<PyResult<Vec<String>>>()?;
        if !(2..=3).contains(&parts.len()) {
            return Err(expected());
        }
        Varied::parse(&format!("{name}={}", parts.join(":"))).map_err(|error| wrong(&error))
    };
    items("vary", vary)?.into_iter().map(range).collect()
}
