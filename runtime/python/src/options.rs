//! Arguments that are given by name.

use crate::errors::{invalid, unknown};
use crate::values::{check_support, number, refused, texts};
use liftoff::__private::expression::si_unit::SECOND;
use liftoff::Condition;
use liftoff::NameError;
use liftoff_core::model::Layout;
use liftoff_studio::registry::MethodId;
use liftoff_studio::run_spec::{PointImpulse, RunSpec};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};

/// What others call arguments, the argument that serves here, and how it is written.
const ELSEWHERE: [(&[&str], &str, &str); 7] = [
    (
        &["t_final", "t_end", "t_span", "tspan", "tf", "duration"],
        "limit",
        "`limit=10` is the latest end, `until=\"t = 10\"` a condition",
    ),
    (&["parameters", "params", "args", "p"], "set", "`set={\"m\": 1}` has the parameters"),
    (
        &["t0", "t_start", "t_begin", "begin"],
        "start",
        "`start={\"t\": 0.3, \"phi\": 0.1}` has the time of the start",
    ),
    (&["x0", "y0", "q0", "initial", "initial_state"], "start", "`start={\"phi\": 0.1}` has the start"),
    (
        &["dt", "step", "max_step", "t_eval", "times"],
        "limit",
        "steps are chosen by the tolerance; `output(\"phi\", t)` of the trajectory has any times, `to_frame(every=0.01)` even ones",
    ),
    (&["rtol", "atol", "tol", "accuracy"], "tolerance", "`tolerance=1e-10` is relative, in natural units"),
    (
        &["events", "event", "terminal", "stop"],
        "until",
        "`until=\"phi = 0\"` ends the run; all events are found anyway",
    ),
];

/// Arguments that are given by name, each taken once.
pub struct Options<'py> {
    function: &'static str,
    given: Option<Bound<'py, PyDict>>,
    taken: Vec<&'static str>,
}

impl<'py> Options<'py> {
    /// Those of a function.
    pub fn new(function: &'static str, given: Option<Bound<'py, PyDict>>) -> Self {
        Self { function, given, taken: Vec::new() }
    }

    /// The same, beside arguments of these names.
    pub fn beside(mut self, names: &[&'static str]) -> Self {
        self.taken.extend(names);
        self
    }

    /// The value of an argument; none where it was not given, or is `None`.
    pub fn take(&mut self, name: &'static str) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.taken.push(name);
        let value = self.given.as_ref().map_or(Ok(None), |given| given.get_item(name))?;
        Ok(value.filter(|value| !value.is_none()))
    }

    /// Refuses arguments that nothing has taken.
    pub fn finish(self) -> PyResult<()> {
        let Some(given) = self.given else { return Ok(()) };
        let names: Vec<String> = given.keys().extract()?;
        match names.iter().find(|name| !self.taken.contains(&name.as_str())) {
            Some(name) => {
                let known = |(names, own, cure): &(&[&str], &str, &'static str)| {
                    (names.contains(&name.as_str()) && self.taken.contains(own)).then_some(*cure)
                };
                let error = match ELSEWHERE.iter().find_map(known) {
                    Some(cure) => format!("no argument `{name}`: {cure}"),
                    None => NameError::new("argument", name, self.taken.iter().copied()).to_string(),
                };
                Err(PyTypeError::new_err(format!("{}(): {error}", self.function)))
            }
            None => Ok(()),
        }
    }

    /// A run with what is planned and how it ends, over its defaults.
    pub fn planned(&mut self, layout: &'static Layout, mut spec: RunSpec) -> PyResult<RunSpec> {
        if let Some(hold) = self.take("hold")? {
            spec.hold = texts("hold", &hold)?;
            spec.hold.iter().try_for_each(|support| check_support(layout, support))?;
        }
        if let Some(cut) = self.take("cut")? {
            spec.cut = cuts(&cut)?;
            spec.cut.iter().try_for_each(|(thread, _)| check_support(layout, thread))?;
        }
        if let Some(impulses) = self.take("impulses")? {
            spec.impulses = blows(&impulses)?;
        }
        if let Some(stop) = self.take("stop_at_impacts")? {
            let expected =
                || PyTypeError::new_err(format!("stop_at_impacts: expected True or False, not {stop}"));
            spec.stop_at_impacts = stop.extract().map_err(|_| expected())?;
        }
        if let Some(limit) = self.take("limit")? {
            spec.limit = Some(seconds("limit", &limit)?);
        }
        if let Some(tolerance) = self.take("tolerance")? {
            spec.tolerance = number("tolerance", &tolerance)?.0;
        }
        Ok(spec)
    }

    /// The method of integration.
    pub fn method(&mut self) -> PyResult<MethodId> {
        let Some(name) = self.take("method")? else { return Ok(MethodId::Auto) };
        let name: String = name.extract()?;
        name.parse().map_err(|error| unknown(&error))
    }
}

/// Refuses conditions that the model cannot watch.
pub fn check_conditions(layout: &'static Layout, spec: &RunSpec) -> PyResult<()> {
    for condition in &spec.until {
        Condition::parse_each(layout, condition).map_err(|error| refused("until", condition, &error))?;
    }
    for (_, condition) in &spec.cut {
        Condition::parse(layout, condition).map_err(|error| refused("cut", condition, &error))?;
    }
    Ok(())
}

/// A time.
pub fn seconds(what: &str, value: &Bound<'_, PyAny>) -> PyResult<f64> {
    let (value, unit) = number(what, value)?;
    match unit.filter(|unit| !unit.agrees(SECOND)) {
        Some(unit) => Err(invalid(format!("{what}: measured in s, not in {}", unit.symbol()))),
        None => Ok(value),
    }
}

fn cuts(given: &Bound<'_, PyAny>) -> PyResult<Vec<(String, String)>> {
    let expected = || PyTypeError::new_err("cut: expected a dict of threads and conditions");
    let items = given.cast::<PyMapping>().map_err(|_| expected())?.items()?;
    items.extract().map_err(|_| expected())
}

fn blows(given: &Bound<'_, PyAny>) -> PyResult<Vec<PointImpulse>> {
    let blows: Result<Vec<(String, [f64; 2], f64)>, _> = given.extract();
    let blows = blows.map_err(|_| {
        PyTypeError::new_err("impulses: expected a list of (point, (px, py), t), `[(\"A\", (1, 0), 0.5)]`")
    })?;
    Ok(blows.into_iter().map(|(point, impulse, at)| PointImpulse { point, impulse, at }).collect())
}
