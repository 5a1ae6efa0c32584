//! What was read of the runs of a sweep: an array for each observation.

use liftoff_studio::sweep::{Cell, Observation, Outcome};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyString;
use std::collections::{BTreeMap, HashMap};

/// What was read of the runs, and why some have failed.
pub struct Columns {
    columns: Vec<Column>,
    failed: BTreeMap<usize, String>,
}

/// What one observation has read.
enum Column {
    /// Not a number where there is no such event, or the run has failed.
    Numbers(Vec<f64>),
    /// Places among the names; those of runs that have failed lie behind them.
    Names(Vec<u32>, HashMap<String, u32>),
}

impl Columns {
    /// Of so many runs.
    pub fn new(observations: &[Observation], runs: usize) -> Self {
        let column = |observation: &Observation| match observation.is_category() {
            true => Column::Names(vec![u32::MAX; runs], HashMap::new()),
            false => Column::Numbers(vec![f64::NAN; runs]),
        };
        Self { columns: observations.iter().map(column).collect(), failed: BTreeMap::new() }
    }

    /// Takes what was read of a run.
    pub fn fill(&mut self, run: usize, outcome: Outcome) {
        match outcome {
            Ok(cells) => self.columns.iter_mut().zip(cells).for_each(|(column, cell)| column.fill(run, cell)),
            Err(reason) => {
                self.failed.insert(run, reason);
            }
        }
    }

    /// As arrays of this shape, and why which runs have failed.
    pub fn into_arrays<'py>(
        self,
        py: Python<'py>,
        shape: &[usize],
    ) -> PyResult<(Arrays<'py>, BTreeMap<usize, String>)> {
        let arrays: PyResult<Vec<_>> =
            self.columns.into_iter().map(|column| column.into_array(py, shape)).collect();
        Ok((arrays?, self.failed))
    }
}

type Arrays<'py> = Vec<Bound<'py, PyAny>>;

impl Column {
    fn fill(&mut self, run: usize, cell: Cell) {
        match (self, cell) {
            (Self::Numbers(values), Cell::Number(value)) => values[run] = value,
            (Self::Names(places, names), Cell::Name(name)) => {
                let next = names.len() as u32;
                places[run] = *names.entry(name).or_insert(next);
            }
            _ => {}
        }
    }

    fn into_array<'py>(self, py: Python<'py>, shape: &[usize]) -> PyResult<Bound<'py, PyAny>> {
        let flat = match self {
            Self::Numbers(values) => values.into_pyarray(py).into_any(),
            Self::Names(places, names) => objects(py, &places, &names).into_any(),
        };
        flat.call_method1("reshape", (shape,))
    }
}

/// Names as objects, each made once; None where there is none.
fn objects<'py>(
    py: Python<'py>,
    places: &[u32],
    names: &HashMap<String, u32>,
) -> Bound<'py, PyArray1<Py<PyAny>>> {
    let mut made: Vec<Py<PyAny>> = (0..names.len()).map(|_| py.None()).collect();
    for (name, place) in names {
        made[*place as usize] = PyString::new(py, name).into_any().unbind();
    }
    let object = |place: &u32| made.get(*place as usize).map_or_else(|| py.None(), |name| name.clone_ref(py));
    places.iter().map(object).collect::<Vec<_>>().into_pyarray(py)
}
