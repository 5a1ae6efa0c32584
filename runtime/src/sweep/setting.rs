//! What of a member depends on the varied names.

use super::SweepError;
use crate::model::Layout;
use crate::names::unknown;
use crate::output::Formula;
use crate::scene::{Setup, Values};

/// What of a setup is set.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Place {
    Parameter,
    Start,
    EnergyOf,
}

/// `name=formula` as it was said.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Said {
    pub(super) place: Place,
    pub(super) name: String,
    pub(super) formula: String,
}

impl Said {
    pub(super) fn parse(place: Place, text: &str) -> Result<Self, SweepError> {
        let (name, formula) =
            text.split_once('=').ok_or_else(|| SweepError::words(text, "expected name=formula"))?;
        Ok(Self { place, name: name.trim().to_owned(), formula: formula.trim().to_owned() })
    }

    /// Its meaning for a model, with these varied names.
    pub(super) fn resolved(&self, varied: &[&str], layout: &'static Layout) -> Result<Setting, SweepError> {
        let Self { place, name, formula } = self;
        if !place.names(layout).iter().any(|known| known == name) {
            return Err(unknown(place.kind(), name, place.names(layout).iter().map(String::as_str)).into());
        }
        let formula = Formula::parse(formula, varied)
            .map_err(|error| SweepError::words(&format!("{name}={formula}"), error))?;
        Ok(Setting { place: *place, name: name.clone(), formula })
    }
}

impl Place {
    /// What can be set there.
    pub(super) fn names(self, layout: &Layout) -> Vec<String> {
        let coordinates = layout.coordinates.iter().map(|coordinate| coordinate.name);
        match self {
            Self::Parameter => layout.parameters.iter().map(|name| (*name).to_owned()).collect(),
            Self::Start | Self::EnergyOf => {
                coordinates.flat_map(|name| [name.to_owned(), format!("{name}'")]).collect()
            }
        }
    }

    pub(super) const fn kind(self) -> &'static str {
        match self {
            Self::Parameter => "parameter",
            Self::Start | Self::EnergyOf => "coordinate",
        }
    }

    /// The word it is said with.
    pub(super) const fn word(self) -> &'static str {
        match self {
            Self::Parameter => "set",
            Self::Start => "start",
            Self::EnergyOf => "energy-of",
        }
    }
}

/// A value of a member's setup as a formula of the varied names.
pub(super) struct Setting {
    place: Place,
    name: String,
    formula: Formula,
}

impl Setting {
    pub(super) fn depends_on(&self, varied: usize) -> bool {
        self.formula.depends_on(varied)
    }

    /// Puts its value at a point into a setup.
    pub(super) fn apply(&self, setup: &mut Setup, point: &[f64]) {
        let values: &mut Values = match self.place {
            Place::Parameter => &mut setup.parameters,
            Place::Start => &mut setup.start,
            Place::EnergyOf => &mut setup.energy_of,
        };
        let value = self.formula.value(point);
        match values.iter_mut().find(|(name, _)| *name == self.name) {
            Some((_, old)) => *old = value,
            None => values.push((self.name.clone(), value)),
        }
    }
}
