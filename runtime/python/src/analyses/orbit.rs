//! Periodic orbits.

use super::beginning::Beginning;
use super::{answer, coordinates};
use crate::errors::{invalid, unknown};
use crate::options::Options;
use crate::values::{items, measured_as, texts};
use liftoff::EventKind;
use liftoff_analysis::{Orbit, OrbitStability};
use liftoff_core::model::Layout;
use liftoff_studio::analyses::{Orbits, find_parameter};
use liftoff_studio::registry::{Entry, Units};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::IntoPyDict;

/// The orbit near a run; where it is to be continued, its branch.
pub fn orbit<'py>(
    py: Python<'py>,
    entry: &Entry,
    section: &str,
    start: Option<&Bound<'py, PyAny>>,
    mut options: Options<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let layout = entry.layout();
    let drift = options.take("drift")?.map_or(Ok(Vec::new()), |given| texts("drift", &given))?;
    let to = options.take("continue_to")?.map(|given| parameter(layout, &given)).transpose()?;
    let beginning = Beginning::from_options(entry, start, &mut options)?;
    options.finish()?;
    let (found, branch) = beginning.search(py, |run| {
        let orbits = Orbits::new(entry, run, section, &drift)?;
        let found = orbits.find()?;
        let branch = to.map(|(parameter, value)| orbits.follow(&found, parameter, value)).transpose()?;
        Ok((found, branch))
    })?;
    let Some(branch) = branch else { return described(py, layout, &found, None) };
    let points = branch
        .points
        .iter()
        .map(|point| described(py, layout, &point.orbit, point.special.map(|special| special.to_string())));
    answer(py, "Branch", (points.collect::<PyResult<Vec<_>>>()?, branch.end.to_string()))
}

/// The place of a parameter, and its final value.
fn parameter(layout: &'static Layout, given: &Bound<'_, PyAny>) -> PyResult<(usize, f64)> {
    match &items("continue_to", given)?[..] {
        [(name, to)] => {
            let place = find_parameter(layout, name).map_err(|error| unknown(&error))?;
            let what = format!("continue_to: {name}");
            Ok((place, measured_as(&Units::from_layout(layout), name, (&what, to))?))
        }
        several => Err(invalid(format!("continue_to: one parameter is followed, not {}", several.len()))),
    }
}

fn described<'py>(
    py: Python<'py>,
    layout: &Layout,
    orbit: &Orbit,
    special: Option<String>,
) -> PyResult<Bound<'py, PyAny>> {
    let parameters = layout.parameters.iter().zip(orbit.parameters.iter().copied()).into_py_dict(py)?;
    let state = layout.names_of_state().zip(orbit.state.iter().copied()).into_py_dict(py)?;
    let shift = coordinates(layout).zip(orbit.shift.iter().copied()).into_py_dict(py)?;
    let event = |(kind, names): &(EventKind, Vec<&'static str>)| (kind.name(), names.clone());
    let events: Vec<_> = orbit.events.iter().map(event).collect();
    let multipliers = orbit.multipliers.clone().into_pyarray(py);
    let stability = match orbit.stability() {
        OrbitStability::Stable => "stable",
        OrbitStability::Neutral => "neutral",
        OrbitStability::Unstable => "unstable",
    };
    let fields =
        (orbit.period, stability, state, parameters, shift, events, multipliers, orbit.residual, special);
    answer(py, "Orbit", fields)
}
