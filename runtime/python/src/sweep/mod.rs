//! Many runs over arrays.
//!
//! - `given`: what is given by names; `inputs`: arrays of one shape; `boundary`: curves in a plane.

pub mod boundary;
mod given;
mod inputs;

use crate::columns::Columns;
use crate::errors::{self, invalid};
use crate::interrupt::watched;
use crate::options::Options;
use crate::values::texts;
use given::Given;
use inputs::Inputs;
use liftoff_studio::registry::{Entry, Place, angle_notes};
use liftoff_studio::run_spec::Values;
use liftoff_studio::sweep::{MOST_THREADS, Observation, Spread, Sweep, SweepError, Varied};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::{Mutex, PoisonError};
use std::thread::available_parallelism;
use std::time::Instant;

/// Runs the model for all values of the arrays.
pub fn run<'py>(
    py: Python<'py>,
    entry: &Entry,
    (observe, vary): (&Bound<'py, PyAny>, Option<&Bound<'py, PyAny>>),
    options: Option<Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let observed = texts("observe", observe)?;
    if observed.is_empty() {
        return Err(invalid("observe: nothing is observed; for example \"end phi\""));
    }
    let mut options = Options::new("sweep", options).beside(&["observe", "vary"]);
    let threads = threads(&mut options)?;
    let given = Given::from_options(entry, vary, &mut options)?;
    options.finish()?;
    let Inputs { shape, varied, arrays } = Inputs::from_arrays(py, &given.arrays)?;
    let starts: Values = given.spec.start.iter().cloned().chain(varied.iter().map(largest)).collect();
    angle_notes(entry.layout(), &starts).try_for_each(|text| errors::warn(py, &text))?;
    let sweep =
        prepared(entry, given, varied, &observed).map_err(|error| errors::sweep(&error))?.threads(threads);
    let layout = entry.layout();
    let observations: Result<Vec<_>, SweepError> =
        observed.iter().map(|text| Observation::parse(text, layout)).collect();
    let observations = observations.map_err(|error| errors::sweep(&error))?;
    let columns = Mutex::new(Columns::new(&observations, shape.iter().product()));
    let begun = Instant::now();
    let ran = watched(py, |stop| {
        sweep.cancel(stop).each_paired(&|run, outcome| {
            columns.lock().unwrap_or_else(PoisonError::into_inner).fill(run, outcome);
        })
    })?;
    ran.map_err(|error| errors::sweep(&error))?;
    let seconds = begun.elapsed().as_secs_f64();
    let columns = columns.into_inner().unwrap_or_else(PoisonError::into_inner);
    let (read, failed) = columns.into_arrays(py, &shape)?;
    let inputs = PyDict::new(py);
    arrays.into_iter().try_for_each(|(name, values)| inputs.set_item(name, values))?;
    let values = PyDict::new(py);
    observed.iter().zip(read).try_for_each(|(name, array)| values.set_item(name, array))?;
    py.import("liftoff._table")?.getattr("Table")?.call1((
        layout.name,
        shape,
        inputs,
        values,
        failed,
        seconds,
    ))
}

/// The value of the largest size.
fn largest(varied: &Varied) -> (String, f64) {
    let values = if let Spread::Listed(values) = &varied.spread { &values[..] } else { &[] };
    let value = values.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()));
    (varied.name.clone(), value.unwrap_or(0.0))
}

fn threads(options: &mut Options<'_>) -> PyResult<usize> {
    let Some(threads) = options.take("threads")? else {
        return Ok(available_parallelism().map_or(1, usize::from));
    };
    let whole = threads.extract().ok().filter(|count| (1..=MOST_THREADS).contains(count));
    whole.ok_or_else(|| invalid(format!("threads: a whole number from 1 to {MOST_THREADS}, not {threads}")))
}

fn prepared<'a>(
    entry: &'a Entry,
    given: Given<'_>,
    varied: Vec<Varied>,
    observed: &[String],
) -> Result<Sweep<'a>, SweepError> {
    let sweep = varied.into_iter().fold(Sweep::new(entry).spec(given.spec), Sweep::over);
    let sweep = given.formulas.iter().try_fold(sweep, |sweep, (place, text)| match place {
        Place::Parameter => sweep.set(text),
        Place::Start => sweep.start(text),
        Place::EnergyOf => sweep.energy_of(text),
        Place::Release => sweep.release(text),
    })?;
    observed.iter().try_fold(sweep, |sweep, text| sweep.observe(text))
}
