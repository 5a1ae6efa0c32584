//! Equilibria and linearised motions.

use super::{answer, coordinates, matrix};
use crate::errors::{self, invalid, warn};
use crate::options::Options;
use crate::request::pose;
use crate::values::{items, measured_as, texts};
use liftoff_analysis::{Linearisation, Load, Mode, Stability};
use liftoff_core::model::Layout;
use liftoff_studio::analyses::{self, Failure, Rest, describe_motion, find_contacts, find_equilibria};
use liftoff_studio::registry::{Entry, Units};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyComplex, PyString};

/// The equilibria that are found from a start.
pub fn equilibria<'py>(
    py: Python<'py>,
    entry: &Entry,
    start: Option<&Bound<'py, PyAny>>,
    mut options: Options<'py>,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let spec = pose(entry, start, &mut options)?;
    let load = options.take("load")?.map(|given| load(entry.layout(), &given)).transpose()?;
    options.finish()?;
    let load = load.as_ref().map(|(name, to)| (name.as_str(), *to));
    let found = py.detach(|| find_equilibria(entry, &spec, load)).map_err(errors::analysis)?;
    found.iter().map(|rest| equilibrium(py, entry.layout(), rest)).collect()
}

/// The motion about a start, at rest; of a mirrored model that is unfolded, in two parts.
pub fn linearise<'py>(
    py: Python<'py>,
    entry: &Entry,
    start: Option<&Bound<'py, PyAny>>,
    mut options: Options<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let spec = pose(entry, start, &mut options)?;
    let closed = options.take("closed")?.map(|given| texts("closed", &given)).transpose()?;
    let closed = closed.map(|names| if names.is_empty() { "free".to_owned() } else { names.join(",") });
    let unfold = options.take("unfold")?.map_or(Ok(false), |given| given.extract())?;
    options.finish()?;
    let subject = analyses::subject(entry, &spec).map_err(errors::analysis)?;
    let closed = find_contacts(&subject, closed.as_deref()).map_err(errors::analysis)?;
    if !unfold {
        let linear = py.detach(|| analyses::linearise(&subject, closed)).map_err(errors::analysis)?;
        warn_of_motion(py, linear.residual())?;
        return linearisation(py, entry.layout(), &linear);
    }
    let halves = py.detach(|| {
        let unfolded = entry.unfolded().map_err(|error| Failure::Input(format!("unfold: {error}")))?;
        analyses::linearise_halves(&unfolded, &spec.parameters, &subject, closed)
    });
    let halves = halves.map_err(errors::analysis)?;
    let (layout, parts) = (halves.model.layout(), &halves.parts);
    let symmetric = linearisation(py, layout, &parts.symmetric)?;
    let antisymmetric = linearisation(py, layout, &parts.antisymmetric)?;
    warn_of_motion(py, parts.symmetric.residual().max(parts.antisymmetric.residual()))?;
    answer(py, "LinearHalves", (symmetric, antisymmetric, parts.growth_ratio()))
}

fn warn_of_motion(py: Python<'_>, residual: f64) -> PyResult<()> {
    describe_motion(residual).map_or(Ok(()), |text| warn(py, &text))
}

/// A parameter, and the value towards which it goes.
fn load(layout: &'static Layout, given: &Bound<'_, PyAny>) -> PyResult<(String, f64)> {
    if let Ok(name) = given.cast::<PyString>() {
        return Ok((name.to_string(), f64::INFINITY));
    }
    match &items("load", given)?[..] {
        [(name, to)] => {
            let what = format!("load: {name}");
            Ok((name.clone(), measured_as(&Units::from_layout(layout), name, (&what, to))?))
        }
        several => Err(invalid(format!("load: one parameter is a load, not {}", several.len()))),
    }
}

fn equilibrium<'py>(py: Python<'py>, layout: &Layout, rest: &Rest) -> PyResult<Bound<'py, PyAny>> {
    let Rest { equilibrium: rest, limit } = rest;
    let position = coordinates(layout).zip(rest.positions.iter().copied()).into_py_dict(py)?;
    let range = |[least, largest]: [f64; 2]| (least, largest);
    let reactions = rest.loads.iter().map(|load| (load.contact, range(load.normal))).into_py_dict(py)?;
    let friction = |load: &Load| load.friction.map(|force| (load.contact, range(force)));
    let friction = rest.loads.iter().filter_map(friction).into_py_dict(py)?;
    let joint_forces = rest.joint_forces.iter().copied().into_py_dict(py)?;
    let stability = match rest.stability() {
        Stability::Fixed => "fixed",
        Stability::Stable => "stable",
        Stability::Neutral => "neutral",
        Stability::Unstable(_) => "unstable",
    };
    let limit = limit.as_ref().map(|limit| answer(py, "LoadLimit", (limit.value, limit.end.to_string())));
    let linear = linearisation(py, layout, &rest.linear)?;
    let fields =
        (&rest.closed, stability, position, reactions, friction, joint_forces, linear, limit.transpose()?);
    answer(py, "Equilibrium", fields)
}

fn linearisation<'py>(
    py: Python<'py>,
    layout: &Layout,
    linear: &Linearisation,
) -> PyResult<Bound<'py, PyAny>> {
    let modes: PyResult<Vec<_>> = linear.modes().iter().map(|found| mode(py, layout, found)).collect();
    let (a, b, z) = (linear.state_matrix(), linear.input_matrix(), linear.basis());
    let matrices = [(a.shape(), &a), (b.shape(), &b), (z.shape(), z)];
    let [a, b, z] = matrices.map(|(shape, entries)| matrix(py, shape, |place| entries[place]));
    answer(py, "Linearisation", (modes?, a, b, z, linear.residual()))
}

fn mode<'py>(py: Python<'py>, layout: &Layout, mode: &Mode) -> PyResult<Bound<'py, PyAny>> {
    let complex = |re: f64, im: f64| PyComplex::from_doubles(py, re, im);
    let shape = mode.shape.iter().map(|x| complex(x.re, x.im));
    let shape = coordinates(layout).zip(shape).into_py_dict(py)?;
    answer(py, "Mode", (complex(mode.rate.re, mode.rate.im), shape))
}
