//! A motion as arrays.

use crate::errors::{self, invalid};
use crate::event::Event;
use crate::model::Model;
use crate::options::seconds;
use crate::pictures;
use crate::request::Request;
use crate::values::numbers;
use liftoff::{Instant, Output, Trajectory as Motion};
use liftoff_studio::picture::{ChartCurve, ChartNumbers};
use liftoff_studio::registry::run_notes;
use numpy::ndarray::Array2;
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyList, PySlice, PyTuple};

/// Rows of a frame at even times.
const MOST_ROWS: f64 = 1e7;

/// A curve with its name, its unit and its points.
type Drawn<'py> = (String, String, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);
/// The name of the axis, curves, and events with their times.
type Numbers<'py> = (String, Vec<Drawn<'py>>, Vec<(String, Vec<f64>)>);

/// A motion from its start to the event that ended it.
///
/// `trajectory["phi"]` and `trajectory["N(A)"]` are arrays over the times `trajectory.t`, the ends
/// of the steps of the integration; `trajectory.output("N(A)", t)` has the values at any times. At
/// an event they are those after it. Times of impacts and impulses stand twice in `trajectory.t`,
/// and so do the rows of the arrays: before, then after.
#[pyclass(frozen, mapping, module = "liftoff")]
pub struct Trajectory {
    model: Py<Model>,
    request: Request,
    motion: Motion,
    stopped: Option<String>,
    t: PyOnceLock<Py<PyArray1<f64>>>,
    state: PyOnceLock<Py<PyArray2<f64>>>,
    events: PyOnceLock<Py<PyList>>,
}

impl Trajectory {
    pub fn new(model: Py<Model>, request: Request, motion: Motion, stopped: Option<String>) -> Self {
        let (t, state, events) = (PyOnceLock::new(), PyOnceLock::new(), PyOnceLock::new());
        Self { model, request, motion, stopped, t, state, events }
    }

    fn expression(&self, text: &str) -> PyResult<Output> {
        self.motion.output(text).map_err(|error| errors::expression(&error))
    }

    /// Its place among the columns of the state.
    fn column(&self, text: &str) -> Option<usize> {
        self.motion.layout().names_of_state().position(|name| name == text.trim())
    }

    /// Times that were asked for, all within the run.
    fn times<'py>(&self, t: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
        let times = numbers(t)?.cast_into::<PyArrayDyn<f64>>()?.readonly();
        let [start, end] = self.motion.interval();
        match times.as_array().iter().find(|t| !(start..=end).contains(*t)) {
            Some(t) => Err(invalid(format!(
                "t = {t} is not within the run, which began at t = {start} and ended at t = {end}"
            ))),
            None => Ok(times),
        }
    }
}

#[pymethods]
impl Trajectory {
    /// The model that moved.
    #[getter]
    fn model(&self, py: Python<'_>) -> Py<Model> {
        self.model.clone_ref(py)
    }

    /// What happened, in order of time; the last event ended the run.
    #[getter]
    fn events<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let events = || {
            let events = self.motion.events().iter().map(|event| Event::from_event(event, &self.motion));
            let events: PyResult<Vec<Py<Event>>> = events.map(|event| Py::new(py, event)).collect();
            Ok::<_, PyErr>(PyList::new(py, events?)?.unbind())
        };
        Ok(self.events.get_or_try_init(py, events)?.bind(py).clone())
    }

    /// The ends of the integration's steps, in order of time; times at which velocities jump twice,
    /// before and after.
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let made = || {
            let times: Vec<f64> = self.motion.instants().iter().map(|instant| instant.t).collect();
            fixed(times.into_pyarray(py)).map(Bound::unbind)
        };
        Ok(self.t.get_or_try_init(py, made)?.bind(py).clone())
    }

    /// The full state at the times `t`, a row each; its columns are `names`.
    #[getter]
    fn state<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let made = || {
            let states = py.detach(|| states(&self.motion, &self.motion.instants()))?;
            fixed(states.into_pyarray(py)).map(Bound::unbind)
        };
        Ok(self.state.get_or_try_init(py, made)?.bind(py).clone())
    }

    /// Names of the columns of `state`: coordinates, then rates.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.motion.layout().names_of_state().collect()
    }

    /// Why the run stopped short, or None.
    #[getter]
    fn stopped(&self) -> Option<&str> {
        self.stopped.as_deref()
    }

    /// What was decided beside the events, with the time: that a condition was not met, that the
    /// start is an equilibrium, where several motions were possible.
    #[getter]
    fn notes(&self) -> Vec<String> {
        run_notes(&self.motion)
    }

    /// The arguments of `simulate` that ask for this run.
    #[getter]
    fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.request.arguments(py)
    }

    /// Whether it is a column of `state`.
    fn __contains__(&self, name: &str) -> bool {
        self.column(name).is_some()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, output: &str) -> PyResult<Bound<'py, PyAny>> {
        match self.column(output) {
            Some(column) => self.state(py)?.get_item((PySlice::full(py), column)),
            None => self.output(py, output, None),
        }
    }

    /// An expression of the names of the model, `"N(A)"` or `"T + V"`, at the times `t`: a number
    /// or an array of any shape; by default those of `trajectory.t`.
    #[pyo3(signature = (output, t=None))]
    fn output<'py>(
        &self,
        py: Python<'py>,
        output: &str,
        t: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let output = self.expression(output)?;
        let Some(t) = t else {
            let value = |instant: &Instant| self.motion.value_at(&output, *instant);
            let values: Vec<f64> = py.detach(|| self.motion.instants().iter().map(value).collect());
            return Ok(values.into_pyarray(py).into_any());
        };
        let times = self.times(t)?;
        let owned = times.as_array().to_owned();
        let values = py.detach(|| owned.mapv(|t| self.motion.value(&output, t)));
        match values.ndim() {
            0 => Ok(values.sum().into_pyobject(py)?.into_any()),
            _ => Ok(values.into_pyarray(py).into_any()),
        }
    }

    /// The full state at times: the shape of `t`, then a column for each of `names`.
    #[pyo3(name = "at")]
    fn states_at<'py>(&self, py: Python<'py>, t: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let times = self.times(t)?;
        let flat: Vec<Instant> = times.as_array().iter().map(|&t| Instant { t, is_before: false }).collect();
        let states = py.detach(|| states(&self.motion, &flat))?;
        let shape: Vec<usize> = times.shape().iter().copied().chain([states.ncols()]).collect();
        states.into_pyarray(py).call_method1("reshape", (shape,))
    }

    /// The turning points of an output: a list of (t, value, whether it is a minimum).
    fn extrema(&self, py: Python<'_>, output: &str) -> PyResult<Vec<(f64, f64, bool)>> {
        let output = self.expression(output)?;
        let found = py.detach(|| self.motion.extrema(&output));
        Ok(found.into_iter().map(|extremum| (extremum.t, extremum.value, extremum.minimum)).collect())
    }

    /// A frame of pandas over the times `t`, or over all multiples of a time `every`: coordinates
    /// and rates, and what else is named.
    #[pyo3(signature = (*outputs, t=None, every=None))]
    fn to_frame<'py>(
        &self,
        py: Python<'py>,
        outputs: Vec<String>,
        t: Option<Bound<'py, PyAny>>,
        every: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let t = match (t, every) {
            (Some(_), Some(_)) => return Err(invalid("every: the times are given by `t` already")),
            (None, Some(every)) => {
                let times = multiples(seconds("every", every)?, self.motion.interval())?;
                Some(times.into_pyarray(py).into_any())
            }
            (t, None) => t,
        };
        let columns = PyDict::new(py);
        for name in self.names().into_iter().chain(outputs) {
            columns.set_item(&name, self.output(py, &name, t.as_ref())?)?;
        }
        let times = t.map_or_else(|| self.t(py).map(Bound::into_any), Ok)?;
        py.import("liftoff._show")?.getattr("frame")?.call1((columns, times))
    }

    /// Outputs against time, or another output, as SVG; by default coordinates, reactions and
    /// energies.
    #[pyo3(signature = (*outputs, against="t"))]
    fn chart<'py>(
        &self,
        py: Python<'py>,
        outputs: Vec<String>,
        against: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        pictures::check(&self.motion, &outputs)?;
        self.expression(against)?;
        let drawn = py.detach(|| pictures::chart(&self.motion, &outputs, against));
        pictures::svg(py, drawn.map_err(|error| errors::request(&error))?)
    }

    /// Draws outputs against time, or another output, on axes of Matplotlib, `ax` or new ones,
    /// which are returned; by default coordinates.
    ///
    /// Lines stand at the times of events; against another output dots are on the first curve.
    /// All other arguments are those of `Axes.plot`.
    #[pyo3(signature = (*outputs, against="t", ax=None, **style))]
    fn plot<'py>(
        this: &Bound<'py, Self>,
        outputs: Vec<String>,
        against: &str,
        ax: Option<Bound<'py, PyAny>>,
        style: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let drawn = this.py().import("liftoff._plot")?.getattr("motion")?;
        drawn.call1((this, outputs, against, ax, style))
    }

    /// What `plot` draws: the name of the axis, each curve with its name and unit, events with
    /// their times.
    fn _chart_numbers<'py>(
        &self,
        py: Python<'py>,
        outputs: Vec<String>,
        against: &str,
    ) -> PyResult<Numbers<'py>> {
        pictures::check(&self.motion, &outputs)?;
        self.expression(against)?;
        let numbers = py.detach(|| pictures::numbers(&self.motion, &outputs, against));
        let ChartNumbers { against, curves, events } = numbers.map_err(|error| errors::request(&error))?;
        let drawn = |ChartCurve { name, unit, points }| {
            let [x, y] = [0, 1].map(|i| points.iter().map(|point: &[f64; 2]| point[i]).collect::<Vec<f64>>());
            (name, unit, x.into_pyarray(py), y.into_pyarray(py))
        };
        Ok((against, curves.into_iter().map(drawn).collect(), events))
    }

    /// The page that plays the motion, HTML that needs nothing beside itself; outputs are drawn
    /// beside it.
    #[pyo3(signature = (*outputs))]
    fn page<'py>(&self, py: Python<'py>, outputs: Vec<String>) -> PyResult<Bound<'py, PyAny>> {
        pictures::check(&self.motion, &outputs)?;
        let page = py.detach(|| pictures::playing(&self.motion, &outputs, self.stopped.as_deref()));
        pictures::html(py, page.map_err(|error| errors::request(&error))?)
    }

    fn _repr_html_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.page(py, Vec::new())?.call_method0("_repr_html_")
    }

    fn _repr_svg_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.chart(py, Vec::new(), "t")
    }

    fn __repr__(&self) -> String {
        let (name, events) = (self.motion.layout().name, self.motion.events());
        let [start, end] = self.motion.interval();
        let last =
            events.last().map_or_else(|| "nothing computed".to_owned(), |event| event.kind.to_string());
        format!("<Trajectory of {name}: {} events, t = {start} … {end:.6}, {last}>", events.len())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let again = py.import("liftoff._restore")?.getattr("trajectory")?;
        let arguments = (self.model.clone_ref(py), self.request.arguments(py)?);
        Ok((again, arguments.into_pyobject(py)?))
    }
}

/// The multiples of a time from the start to the end of a run.
fn multiples(every: f64, [start, end]: [f64; 2]) -> PyResult<Vec<f64>> {
    if !(every > 0.0 && every.is_finite()) {
        return Err(invalid(format!("every: {every}: expected a time > 0")));
    }
    match (end - start) / every {
        rows if rows > MOST_ROWS => {
            Err(invalid(format!("every {every} would be {rows:.0e} rows: {MOST_ROWS:.0e} are the most")))
        }
        _ => Ok((0..)
            .map(|k| ((start / every).ceil() + f64::from(k)) * every)
            .take_while(|t| *t <= end)
            .collect()),
    }
}

/// The states at instants, row by row.
fn states(motion: &Motion, instants: &[Instant]) -> PyResult<Array2<f64>> {
    let columns = 2 * motion.layout().coordinates.len();
    let row = |instant: &Instant| motion.state_at(*instant).into_iter().take(columns);
    let rows: Vec<f64> = instants.iter().flat_map(row).collect();
    Array2::from_shape_vec((instants.len(), columns), rows).map_err(invalid)
}

/// The same array, which cannot be written to.
fn fixed<'py, T>(array: Bound<'py, T>) -> PyResult<Bound<'py, T>> {
    let flags = PyDict::new(array.py());
    flags.set_item("write", false)?;
    array.as_any().call_method("setflags", (), Some(&flags))?;
    Ok(array)
}
