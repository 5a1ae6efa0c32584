//! What can be changed of a run.

use crate::registry::{Entry, Units};
use crate::run_spec::{RunSpec, Values};
use serde::Serialize;

/// A number that can be changed.
#[derive(Serialize, PartialEq, Debug)]
pub struct Slider {
    /// Its name.
    pub name: String,
    /// What it is measured in.
    pub unit: String,
    /// Its value, if it has one.
    pub value: Option<f64>,
}

/// Those of a run.
#[derive(Serialize, Debug)]
pub struct Sliders {
    /// Of the parameters in order.
    pub parameters: Vec<Slider>,
    /// Of the coordinates and rates in order; those that the start gives have values.
    pub start: Vec<Slider>,
}

impl Sliders {
    /// Those of a run of a model.
    pub fn new(model: &Entry, spec: &RunSpec) -> Self {
        let layout = model.layout();
        let parameters = layout
            .parameters
            .iter()
            .enumerate()
            .map(|(i, name)| slider((*name).to_owned(), layout.defaults.unit(i), &spec.parameters));
        let units = Units::from_layout(layout);
        let start = layout.names_of_motion().map(|name| {
            let unit = units.unit(&name).unwrap_or_default();
            slider(name, &unit, &spec.start)
        });
        Self { parameters: parameters.collect(), start: start.collect() }
    }
}

fn slider(name: String, unit: &str, values: &Values) -> Slider {
    let value = values.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
    Slider { name, unit: unit.to_owned(), value }
}
