//! Numbers and texts as they are given.

use crate::errors::{expression, invalid, unknown};
use liftoff::__private::expression::si_unit::SiUnit;
use liftoff::__private::expression::{contact_of, unknown_support};
use liftoff::{NameError, OutputError};
use liftoff_core::model::Layout;
use liftoff_studio::registry::{Place, Quantity, Units};
use liftoff_studio::run_spec::Values;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyMapping, PyString};

/// The entries of a mapping.
pub type Entries<'py> = Vec<(String, Bound<'py, PyAny>)>;

/// The entries of what was given as `place`, its names being those of the model.
pub fn entries<'py>(
    place: Place,
    layout: &'static Layout,
    given: &Bound<'py, PyAny>,
) -> PyResult<Entries<'py>> {
    let entries = items(keyword(place), given)?;
    entries.iter().try_for_each(|(name, _)| check_name(place, layout, name))?;
    Ok(entries)
}

/// The items of a mapping.
pub fn items<'py>(what: &str, given: &Bound<'py, PyAny>) -> PyResult<Entries<'py>> {
    let expected =
        || PyTypeError::new_err(format!("{what}: expected a dict of names and values, `{{\"phi\": 0.1}}`"));
    given.cast::<PyMapping>().map_err(|_| expected())?.items()?.extract()
}

/// An array of numbers where they may be read: those of a message or a file, as Dask and `memmap`
/// give them, may stand at any address, and are copied to one that is a multiple of their size.
pub fn numbers<'py>(values: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let numpy = values.py().import("numpy")?;
    numpy.call_method1("require", (values, numpy.getattr("float64")?, ["ALIGNED", "ENSUREARRAY"]))
}

/// Numbers by the names of the model, each in a unit of what it measures.
pub fn named(place: Place, layout: &'static Layout, given: &Bound<'_, PyAny>) -> PyResult<Values> {
    let value = |(name, value): (String, Bound<'_, PyAny>)| {
        let value = measured(place, layout, &name, &value)?;
        Ok((name, value))
    };
    entries(place, layout, given)?.into_iter().map(value).collect()
}

/// A number that this name may have.
pub fn measured(
    place: Place,
    layout: &'static Layout,
    name: &str,
    value: &Bound<'_, PyAny>,
) -> PyResult<f64> {
    let what = format!("{}: {name}", keyword(place));
    let (value, unit) = number(&what, value)?;
    let checked = place.check_unit(layout, name, unit);
    checked.map(|()| value).map_err(|text| invalid(text.trim_start_matches("--")))
}

/// A number, or the text of one, which may have a unit: `"85deg"`, `"pi/4"`.
pub fn number(what: &str, value: &Bound<'_, PyAny>) -> PyResult<(f64, Option<SiUnit>)> {
    if let Ok(text) = value.cast::<PyString>() {
        let text = text.to_string();
        let formula = Quantity::parse(&text, &[]);
        let formula = formula.map_err(|error| invalid(format!("{what}: `{text}` is no number: {error}")))?;
        return Ok((formula.value(&[]), formula.unit()));
    }
    let number = value.extract::<f64>();
    let expected = |_| {
        let given = value.repr().map_or_else(|_| String::new(), |text| format!(", not {text}"));
        let several = if value.len().is_ok() { "; `sweep` runs arrays" } else { "" };
        PyTypeError::new_err(format!("{what}: expected a number or its text{given}{several}"))
    };
    Ok((number.map_err(expected)?, None))
}

/// A number in a unit of what an output, parameter or coordinate of this name measures.
pub fn measured_as(units: &Units, name: &str, (what, value): (&str, &Bound<'_, PyAny>)) -> PyResult<f64> {
    let (value, unit) = number(what, value)?;
    units.check(name, unit).map(|()| value).map_err(|why| invalid(format!("{what}: {why}")))
}

/// One text or several.
pub fn texts(what: &str, value: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(vec![text.to_string()]);
    }
    value
        .extract()
        .map_err(|_| PyTypeError::new_err(format!("{what}: expected a text or a list of texts, not {value}")))
}

/// Refuses what is no support of the model.
pub fn check_support(layout: &'static Layout, support: &str) -> PyResult<()> {
    match contact_of(layout, support) {
        Some(_) => Ok(()),
        None => Err(unknown(&unknown_support(layout, support))),
    }
}

/// An expression that was refused, by what it was given as.
pub fn refused(what: &str, text: &str, error: &OutputError) -> PyErr {
    match error {
        OutputError::Name(_) => expression(error),
        _ => invalid(format!("{what}: `{text}`: {error}")),
    }
}

fn check_name(place: Place, layout: &'static Layout, name: &str) -> PyResult<()> {
    match place {
        Place::Release => return check_support(layout, name),
        // What is said of a support is checked where it is read.
        Place::Start if name.starts_with("below(") => return Ok(()),
        _ => {}
    }
    let known = place.names(layout);
    let found = known.iter().any(|known| known == name);
    let missing = || unknown(&NameError::new(place.kind(), name, known.iter().map(String::as_str)));
    if found { Ok(()) } else { Err(missing()) }
}

/// The argument that it is given by.
pub fn keyword(place: Place) -> &'static str {
    match place {
        Place::EnergyOf => "energy_of",
        other => other.word(),
    }
}
