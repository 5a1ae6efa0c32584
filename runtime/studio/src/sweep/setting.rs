//! What of a member depends on the varied names.

use super::SweepError;
use crate::registry::{Place, Quantity};
use crate::run_spec::{RunSpec, Values};
use liftoff::__private::expression::normalize_rate;
use liftoff::NameError;
use liftoff_core::model::Layout;

/// `name=formula` as it was given.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Assignment {
    pub(super) target: Place,
    pub(super) name: String,
    pub(super) formula: String,
}

impl Assignment {
    pub(super) fn parse(target: Place, text: &str) -> Result<Self, SweepError> {
        let (name, formula) =
            text.split_once('=').ok_or_else(|| SweepError::syntax(text, "expected name=formula"))?;
        Ok(Self {
            target,
            name: normalize_rate(name.trim()).into_owned(),
            formula: formula.trim().to_owned(),
        })
    }

    /// Its meaning for a model, with these varied names.
    pub(super) fn resolved(&self, varied: &[&str], layout: &'static Layout) -> Result<Setting, SweepError> {
        let Self { target, name, formula } = self;
        if !target.names(layout).iter().any(|known| known == name) {
            return Err(
                NameError::new(target.kind(), name, target.names(layout).iter().map(String::as_str)).into()
            );
        }
        let formula = Quantity::parse(formula, varied)
            .map_err(|error| SweepError::syntax(&format!("{name}={formula}"), error))?;
        target.check_unit(layout, name, formula.unit()).map_err(SweepError::Invalid)?;
        Ok(Setting { target: *target, name: name.clone(), formula })
    }
}

/// A value of a member's spec as a formula of the varied names.
pub(super) struct Setting {
    target: Place,
    name: String,
    formula: Quantity,
}

impl Setting {
    pub(super) fn depends_on(&self, varied: usize) -> bool {
        self.formula.depends_on(varied)
    }

    /// Puts its value at a point into a spec.
    pub(super) fn apply(&self, spec: &mut RunSpec, point: &[f64]) {
        let values: &mut Values = match self.target {
            Place::Parameter => &mut spec.parameters,
            Place::Start => &mut spec.start,
            Place::EnergyOf => &mut spec.energy_of,
            Place::Release => &mut spec.release,
        };
        let value = self.formula.value(point);
        match values.iter_mut().find(|(name, _)| *name == self.name) {
            Some((_, old)) => *old = value,
            None => values.push((self.name.clone(), value)),
        }
    }
}
