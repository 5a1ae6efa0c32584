//! What of an observation makes a difference.

use super::cell::{Cell, Outcome};
use super::{Observation, SweepError};
use crate::registry::{Quantity, Units};
use liftoff::__private::expression::si_unit::SiUnit;
use liftoff_core::model::Layout;

/// What of an observation makes a difference.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) enum Criterion {
    /// Its category.
    #[default]
    Category,
    /// On which side of a value it is.
    Side(f64, Option<SiUnit>),
}

impl Criterion {
    /// An observation, and the value after its `=`.
    pub(super) fn split(text: &str) -> Result<(&str, Self), SweepError> {
        let Some((observation, value)) = text.split_once('=') else { return Ok((text, Self::Category)) };
        let quantity = Quantity::parse(value, &[]).map_err(|error| SweepError::syntax(text, error))?;
        Ok((observation, Self::Side(quantity.value(&[]), quantity.unit())))
    }

    pub(super) fn value(self) -> Option<f64> {
        if let Self::Side(value, _) = self { Some(value) } else { None }
    }

    /// Whether what is observed has it, and is one thing.
    pub(super) fn check(
        self,
        observations: &[Observation],
        layout: &'static Layout,
    ) -> Result<(), SweepError> {
        let [observation] = observations else {
            return Err(SweepError::Invalid("a threshold needs exactly one observation".into()));
        };
        match (observation.is_category(), self) {
            (false, Self::Category) => {
                let text = observation.text();
                Err(SweepError::Invalid(format!(
                    "`{text}` is a number: say which it is to reach, `{text} = 0`"
                )))
            }
            (true, Self::Side(..)) => {
                Err(SweepError::Invalid(format!("`{}` is no number", observation.text())))
            }
            (false, Self::Side(_, unit)) => {
                let output = observation.output().map(ToString::to_string).unwrap_or_default();
                let wrong = |wrong| SweepError::Invalid(format!("`{}`: {wrong}", observation.text()));
                Units::from_layout(layout).check(&output, unit).map_err(wrong)
            }
            (true, Self::Category) => Ok(()),
        }
    }

    pub(super) fn label(self, outcome: &Outcome) -> String {
        match (outcome, self) {
            (Err(_), _) => "failed".into(),
            (Ok(cells), Self::Side(value, _)) => match cells.first().and_then(Cell::number) {
                Some(number) if number < value => format!("< {value}"),
                Some(number) if number > value => format!("> {value}"),
                Some(_) => format!("= {value}"),
                None => "none".into(),
            },
            (Ok(cells), Self::Category) => cells.first().map_or("none".into(), ToString::to_string),
        }
    }
}
