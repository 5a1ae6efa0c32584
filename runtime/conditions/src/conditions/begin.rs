//! The start that is given.

use super::Request;
use crate::error::ConditionError;
use crate::level::Start;
use crate::numeric::chart::{Place, quarters};
use crate::phase::Named;

/// The start that is given.
pub(super) struct Begin {
    pub place: Option<Place>,
    quarters: Option<i64>,
    pub rate: f64,
}

impl Begin {
    pub fn from_request(named: &Named, coordinate: usize, request: &Request) -> Result<Self, ConditionError> {
        let of = &named.analysis.kinematics.coordinates[coordinate];
        let (own, rate_name) = (of.name.as_str(), format!("{}'", of.name));
        let stranger = request.start.iter().find(|(name, _)| *name != own && *name != rate_name);
        if let Some((asked, _)) = stranger {
            let (phase, coordinate) = (named.title(), own.to_owned());
            return Err(ConditionError::Start { phase, coordinate, asked: asked.clone() });
        }
        let given =
            |name: &str| request.start.iter().rev().find(|(known, _)| known == name).map(|(_, value)| *value);
        let [plain, turns] = named.occurs(coordinate);
        let not_finite = || ConditionError::NotFinite { name: own.to_owned() };
        let place =
            given(own).map(|value| Place::from_value(value, turns).ok_or_else(not_finite)).transpose()?;
        let rate = given(&rate_name).unwrap_or(0.0);
        Ok(Self { place, quarters: given(own).filter(|_| turns && !plain).and_then(quarters), rate })
    }

    pub fn start(&self) -> Start {
        match self.quarters {
            _ if self.rate != 0.0 => Start::Moving,
            Some(turns) => Start::Quarters(turns),
            None => Start::Rest,
        }
    }
}
