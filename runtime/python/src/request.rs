//! What a run is asked for.

use crate::options::{Options, check_conditions};
use crate::values::{named, texts};
use liftoff_studio::registry::{Entry, MethodId, Place};
use liftoff_studio::run_spec::{RunSpec, Values, overridden};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

/// What a run is asked for.
#[derive(Clone)]
pub struct Request {
    pub spec: RunSpec,
    pub method: MethodId,
}

impl Request {
    /// The default run of a model, overridden by the arguments.
    pub fn from_options(
        entry: &Entry,
        start: Option<&Bound<'_, PyAny>>,
        until: Option<&Bound<'_, PyAny>>,
        options: &mut Options<'_>,
    ) -> PyResult<Self> {
        let layout = entry.layout();
        let spec = pose(entry, start, options)?;
        let mut spec = options.planned(layout, spec)?;
        if let Some(until) = until {
            spec.until = texts("until", until)?;
        }
        if let Some(level) = options.take("energy_of")? {
            spec.energy_of = named(Place::EnergyOf, layout, &level)?;
        }
        if let Some(release) = options.take("release")? {
            spec.release = named(Place::Release, layout, &release)?;
        }
        let method = options.method()?;
        check_conditions(layout, &spec)?;
        Ok(Self { spec, method })
    }

    /// The arguments that ask for it.
    pub fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let arguments = spec_arguments(py, &self.spec)?;
        arguments.set_item("method", self.method.name())?;
        Ok(arguments)
    }
}

/// The default run of a model with other parameters, from another start. That drops the default
/// energy level too.
pub fn pose(entry: &Entry, start: Option<&Bound<'_, PyAny>>, options: &mut Options<'_>) -> PyResult<RunSpec> {
    let mut spec = entry.default_run();
    if let Some(set) = options.take("set")? {
        spec.parameters = overridden(spec.parameters, &named(Place::Parameter, entry.layout(), &set)?);
    }
    if let Some(start) = start {
        spec.start = named(Place::Start, entry.layout(), start)?;
        spec.energy_of.clear();
    }
    Ok(spec)
}

/// The arguments that ask for a run.
pub fn spec_arguments<'py>(py: Python<'py>, spec: &RunSpec) -> PyResult<Bound<'py, PyDict>> {
    let arguments = PyDict::new(py);
    let values = |values: &Values| values.clone().into_py_dict(py);
    arguments.set_item("set", values(&spec.parameters)?)?;
    arguments.set_item("start", values(&spec.start)?)?;
    arguments.set_item("until", &spec.until)?;
    arguments.set_item("limit", spec.limit)?;
    arguments.set_item("tolerance", spec.tolerance)?;
    if !spec.energy_of.is_empty() {
        arguments.set_item("energy_of", values(&spec.energy_of)?)?;
    }
    arguments.set_item("hold", &spec.hold)?;
    arguments.set_item("release", values(&spec.release)?)?;
    arguments.set_item("cut", spec.cut.clone().into_py_dict(py)?)?;
    let blows =
        spec.impulses.iter().map(|blow| (blow.point.clone(), (blow.impulse[0], blow.impulse[1]), blow.at));
    arguments.set_item("impulses", blows.collect::<Vec<_>>())?;
    arguments.set_item("stop_at_impacts", spec.stop_at_impacts)?;
    Ok(arguments)
}
