//! Many runs over arrays.

use crate::columns::Columns;
use crate::errors::{self, invalid};
use crate::interrupt::watched;
use crate::options::Options;
use crate::request::override_values;
use crate::values::{entries, keyword, measured, texts};
use liftoff_studio::registry::{Entry, Place};
use liftoff_studio::run_spec::{RunSpec, Values};
use liftoff_studio::sweep::{MOST_MEMBERS, MOST_THREADS, Observation, Spread, Sweep, SweepError, Varied};
use numpy::{PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping, PyString};
use std::sync::{Mutex, PoisonError};
use std::thread::available_parallelism;
use std::time::Instant;

/// What of a sweep is given by names: arrays, expressions, and numbers in the run.
struct Given<'py> {
    spec: RunSpec,
    arrays: Vec<(String, Bound<'py, PyAny>)>,
    formulas: Vec<(Place, String)>,
}

/// Runs the model for all values of the arrays.
pub fn run<'py>(
    py: Python<'py>,
    entry: &Entry,
    (observe, vary): (&Bound<'py, PyAny>, Option<&Bound<'py, PyAny>>),
    options: Option<Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let observed = texts("observe", observe)?;
    let mut options = Options::new("sweep", options);
    let threads = threads(&mut options)?;
    let given = Given::of(entry, vary, &mut options)?;
    options.finish()?;
    let Inputs { shape, varied, arrays } = Inputs::of(py, &given.arrays)?;
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

fn threads(options: &mut Options<'_>) -> PyResult<usize> {
    let Some(threads) = options.take("threads")? else {
        return Ok(available_parallelism().map_or(1, usize::from));
    };
    let threads: usize = threads.extract()?;
    match threads {
        1..=MOST_THREADS => Ok(threads),
        _ => Err(invalid(format!("threads: a number from 1 to {MOST_THREADS}, not {threads}"))),
    }
}

fn prepared<'a>(
    entry: &'a Entry,
    given: Given<'_>,
    varied: Vec<Varied>,
    observed: &[String],
) -> Result<Sweep<'a>, SweepError> {
    let sweep = varied.into_iter().fold(Sweep::of(entry).spec(given.spec), Sweep::over);
    let sweep = given.formulas.iter().try_fold(sweep, |sweep, (place, text)| match place {
        Place::Parameter => sweep.set(text),
        Place::Start => sweep.start(text),
        Place::EnergyOf => sweep.energy_of(text),
        Place::Release => sweep.release(text),
    })?;
    observed.iter().try_fold(sweep, |sweep, text| sweep.observe(text))
}

impl<'py> Given<'py> {
    fn of(entry: &Entry, vary: Option<&Bound<'py, PyAny>>, options: &mut Options<'py>) -> PyResult<Self> {
        let layout = entry.layout();
        let spec = options.planned(layout, entry.default_run())?;
        let mut given = Self { spec, arrays: Vec::new(), formulas: Vec::new() };
        if let Some(until) = options.take("until")? {
            given.spec.until = texts("until", &until)?;
        }
        if let Some(vary) = vary {
            let expected = || invalid("vary: expected a dict of names and arrays");
            let items = vary.cast::<PyMapping>().map_err(|_| expected())?.items()?;
            given.arrays = items.extract().map_err(|_| expected())?;
        }
        for place in [Place::Parameter, Place::Start, Place::EnergyOf, Place::Release] {
            if let Some(values) = options.take(keyword(place))? {
                given.take(entry, place, &values)?;
            }
        }
        if given.arrays.is_empty() {
            return Err(invalid("nothing is varied: give an array or a list in place of a number"));
        }
        Ok(given)
    }

    /// Texts are expressions, what has a length is varied, all else is a number of the run.
    fn take(&mut self, entry: &Entry, place: Place, given: &Bound<'py, PyAny>) -> PyResult<()> {
        let mut numbers = Values::new();
        for (name, value) in entries(place, entry.layout(), given)? {
            if let Ok(text) = value.cast::<PyString>() {
                self.formulas.push((place, format!("{name}={text}")));
            } else if value.len().is_ok() {
                let own = match place {
                    Place::Parameter | Place::Start => name,
                    Place::EnergyOf | Place::Release => self.renamed(place, &name),
                };
                self.arrays.push((own, value));
            } else {
                numbers.push((name.clone(), measured(place, entry.layout(), &name, &value)?));
            }
        }
        match place {
            Place::Parameter => override_values(&mut self.spec.parameters, numbers),
            Place::Start => {
                self.spec.start = numbers;
                self.spec.energy_of.clear();
            }
            Place::EnergyOf => self.spec.energy_of = numbers,
            Place::Release => self.spec.release = numbers,
        }
        Ok(())
    }

    /// A varied name that is none of the model's, and the setting that takes it.
    fn renamed(&mut self, place: Place, name: &str) -> String {
        let own = format!("{}_{}", keyword(place), name.replace('\'', "_rate"));
        self.formulas.push((place, format!("{name}={own}")));
        own
    }
}

/// Arrays as NumPy broadcasts them.
struct Inputs<'py> {
    shape: Vec<usize>,
    varied: Vec<Varied>,
    arrays: Vec<(String, Bound<'py, PyAny>)>,
}

impl<'py> Inputs<'py> {
    fn of(py: Python<'py>, given: &[(String, Bound<'py, PyAny>)]) -> PyResult<Self> {
        let numpy = py.import("numpy")?;
        let float = numpy.getattr("float64")?;
        let mut arrays = Vec::new();
        for (name, values) in given {
            let array = numpy.call_method1("asarray", (values, &float));
            arrays.push(array.map_err(|error| invalid(format!("{name}: {}", error.value(py))))?);
        }
        let shapes: PyResult<Vec<Vec<usize>>> =
            arrays.iter().map(|array| array.getattr("shape")?.extract()).collect();
        let shapes = shapes?;
        let shape = broadcast(&shapes).ok_or_else(|| {
            let told = given.iter().zip(&shapes).map(|((name, _), shape)| format!("{name} {shape:?}"));
            invalid(format!("arrays whose shapes do not agree: {}", told.collect::<Vec<_>>().join(", ")))
        })?;
        let runs = shape.iter().try_fold(1, |product: usize, length| product.checked_mul(*length));
        if runs.is_none_or(|runs| runs > MOST_MEMBERS) {
            return Err(invalid(format!("shape {shape:?}: {MOST_MEMBERS} runs are the most")));
        }
        let mut inputs = Self { shape, varied: Vec::new(), arrays: Vec::new() };
        for ((name, _), array) in given.iter().zip(arrays) {
            let array = numpy.call_method1("broadcast_to", (array, inputs.shape.clone()))?;
            let values = array.cast::<PyArrayDyn<f64>>()?.readonly();
            let spread = Spread::Listed(values.as_array().iter().copied().collect());
            inputs.varied.push(Varied { name: name.clone(), spread, units: Vec::new() });
            inputs.arrays.push((name.clone(), array));
        }
        Ok(inputs)
    }
}

/// The shape that all of these are broadcast to.
fn broadcast(shapes: &[Vec<usize>]) -> Option<Vec<usize>> {
    let dimensions = shapes.iter().map(Vec::len).max().unwrap_or(0);
    let mut shape = vec![1; dimensions];
    for given in shapes {
        for (length, own) in shape.iter_mut().rev().zip(given.iter().rev()) {
            match (*length, *own) {
                (a, b) if a == b || b == 1 => {}
                (1, b) => *length = b,
                _ => return None,
            }
        }
    }
    Some(shape)
}
