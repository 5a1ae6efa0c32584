//! What of a sweep is given by names.

use crate::errors::invalid;
use crate::options::Options;
use crate::values::{entries, keyword, measured, texts};
use liftoff_core::model::Layout;
use liftoff_studio::registry::{Entry, Place};
use liftoff_studio::run_spec::{RunSpec, Values, overridden};
use pyo3::prelude::*;
use pyo3::types::{PyMapping, PyString};

/// What of a sweep is given by names: arrays, expressions, and numbers in the run.
pub struct Given<'py> {
    pub spec: RunSpec,
    pub arrays: Vec<(String, Bound<'py, PyAny>)>,
    pub formulas: Vec<(Place, String)>,
}

impl<'py> Given<'py> {
    /// Of the arguments of a sweep.
    pub fn from_options(
        entry: &Entry,
        vary: Option<&Bound<'py, PyAny>>,
        options: &mut Options<'py>,
    ) -> PyResult<Self> {
        let mut arrays = Vec::new();
        if let Some(vary) = vary {
            let expected = || invalid("vary: expected a dict of names and arrays");
            let items = vary.cast::<PyMapping>().map_err(|_| expected())?.items()?;
            arrays = items.extract().map_err(|_| expected())?;
        }
        let mut given = Self::take(entry, options)?;
        arrays.append(&mut given.arrays);
        if arrays.is_empty() {
            return Err(invalid("nothing is varied: give an array or a list in place of a number"));
        }
        Ok(Self { arrays, ..given })
    }

    /// Of arguments that are given by name.
    pub fn take(entry: &Entry, options: &mut Options<'py>) -> PyResult<Self> {
        let spec = options.planned(entry.layout(), entry.default_run())?;
        let mut given = Self { spec, arrays: Vec::new(), formulas: Vec::new() };
        if let Some(until) = options.take("until")? {
            given.spec.until = texts("until", &until)?;
        }
        for place in [Place::Parameter, Place::Start, Place::EnergyOf, Place::Release] {
            if let Some(values) = options.take(keyword(place))? {
                given.add(entry, place, &values)?;
            }
        }
        Ok(given)
    }

    /// Texts are expressions, what has a length is varied, all else is a number of the run.
    fn add(&mut self, entry: &Entry, place: Place, given: &Bound<'py, PyAny>) -> PyResult<()> {
        let mut numbers = Values::new();
        for (name, value) in entries(place, entry.layout(), given)? {
            if let Ok(text) = value.cast::<PyString>() {
                self.formulas.push((place, format!("{name}={text}")));
            } else if value.len().is_ok() {
                let own = match place {
                    Place::Parameter | Place::Start => name.clone(),
                    Place::EnergyOf | Place::Release => self.renamed(place, &name),
                };
                self.arrays.push((own, without_units(place, entry.layout(), &name, value)?));
            } else {
                numbers.push((name.clone(), measured(place, entry.layout(), &name, &value)?));
            }
        }
        match place {
            Place::Parameter => {
                let known = core::mem::take(&mut self.spec.parameters);
                self.spec.parameters = overridden(known, &numbers);
            }
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

/// The values of a list of texts, `["60deg", "70deg"]`; anything else as it is.
fn without_units<'py>(
    place: Place,
    layout: &'static Layout,
    name: &str,
    given: Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let Ok(texts) = given.extract::<Vec<Bound<'py, PyString>>>() else { return Ok(given) };
    let values = texts.iter().map(|text| measured(place, layout, name, text));
    Ok(values.collect::<PyResult<Vec<f64>>>()?.into_pyobject(given.py())?.into_any())
}
