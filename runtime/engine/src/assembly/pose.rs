//! A pose as the user gives it: some coordinates, some rates.

use crate::error::NameError;
use crate::error::StartError;
use crate::integration::phase_point::RunContext;
use crate::model::Layout;
use crate::model::names::CoordinateName;

/// Some coordinates and rates by name; a rate is named with a prime, `phi'`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pose {
    values: Vec<(String, f64)>,
}

impl Pose {
    /// The nominal figure at rest.
    pub fn nominal() -> Self {
        Self::default()
    }

    /// One coordinate or rate given.
    pub fn at(name: impl CoordinateName, value: f64) -> Self {
        Self::nominal().with(name, value)
    }

    /// One more coordinate or rate given.
    #[must_use]
    pub fn with(mut self, name: impl CoordinateName, value: f64) -> Self {
        self.values.push((name.as_ref().to_owned(), value));
        self
    }

    /// All coordinates and all rates given, in the order of a state.
    pub fn of_state(layout: &Layout, state: &[f64]) -> Self {
        Self { values: layout.names_of_state().zip(state.iter().copied()).collect() }
    }

    /// The coordinates and the rates given, in their places; elsewhere what they are nominally, and zero.
    pub(crate) fn values(&self, layout: &Layout, nominal: &[f64]) -> Result<[Vec<f64>; 2], StartError> {
        let Given { positions, rates } = self.resolve(layout)?;
        let positions = positions.iter().zip(nominal).map(|(given, nominal)| given.unwrap_or(*nominal));
        Ok([positions.collect(), rates.into_iter().map(Option::unwrap_or_default).collect()])
    }

    pub(super) fn resolve(&self, layout: &Layout) -> Result<Given, StartError> {
        let n = layout.coordinates.len();
        let mut given = Given { positions: vec![None; n], rates: vec![None; n] };
        for (name, value) in &self.values {
            let slot = given.slot(layout, name)?;
            if !value.is_finite() {
                return Err(StartError::NotFinite { name: name.clone(), value: *value });
            }
            if slot.replace(*value).is_some() {
                return Err(StartError::Twice { name: name.clone() });
            }
        }
        Ok(given)
    }
}

/// What is given of each coordinate and rate.
pub(super) struct Given {
    pub(super) positions: Vec<Option<f64>>,
    pub(super) rates: Vec<Option<f64>>,
}

impl Given {
    /// Whether a state has every value that was given, within a relative bound: what was left open follows the contacts.
    pub(super) fn is_kept(&self, context: &RunContext, state: &[f64], bound: f64) -> bool {
        let given = self.positions.iter().chain(&self.rates);
        let entries = given.zip(state).zip(context.scales.state(context.layout()));
        entries.into_iter().all(|((given, value), unit)| {
            given.is_none_or(|given| (value - given).abs() <= bound * unit.max(given.abs()))
        })
    }

    fn slot(&mut self, layout: &Layout, name: &str) -> Result<&mut Option<f64>, StartError> {
        let (base, list) = match name.strip_suffix('\'') {
            Some(base) => (base, &mut self.rates),
            None => (name, &mut self.positions),
        };
        let known = || layout.coordinates.iter().map(|c| c.name);
        match known().position(|c| c == base) {
            Some(i) => Ok(&mut list[i]),
            None => Err(NameError::new("coordinate", base, known()).into()),
        }
    }
}
