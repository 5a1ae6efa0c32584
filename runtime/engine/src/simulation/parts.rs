//! The parts of the engine that only some models need. A run reaches them through this table only,
//! so that what a compiled model does not name is not in its program.

use super::Rules;
use crate::contact::Laws;
use crate::context::RunContext;
use crate::error::ModelError;
use crate::integration::method::{Problem, StartedStepper, cut};
use crate::model::{Layout, QuantityKind};

/// What a model needs of the engine.
#[derive(Clone, Copy)]
pub(crate) struct Parts {
    /// What decides and strikes contacts.
    pub(crate) laws: &'static Laws,
    /// What the declaration says of the course of a run.
    pub(crate) rules: fn(&RunContext) -> Result<Rules, ModelError>,
    /// Cuts steps at kinks of the equations.
    pub(crate) cut: Option<Cut>,
}

type Cut = for<'a> fn(StartedStepper<'a>, &Problem<'a>) -> StartedStepper<'a>;

impl Parts {
    /// Those of a model.
    pub(crate) const fn from_layout(layout: &Layout) -> Self {
        Self {
            laws: Laws::from_layout(layout),
            rules: if has_rules(layout) { Rules::from_model } else { |_| Ok(Rules::default()) },
            cut: if layout.kinks.is_empty() { None } else { Some(cut) },
        }
    }
}

/// Whether anything comes and goes, follows time, or has a bound.
const fn has_rules(layout: &Layout) -> bool {
    let mut has = !layout.switches.is_empty() || !layout.signals.is_empty();
    let mut i = 0;
    while i < layout.contacts.len() {
        has |= layout.contacts[i].armed.is_some() || layout.contacts[i].breaks.is_some();
        i += 1;
    }
    i = 0;
    while i < layout.frictions.len() {
        has |= layout.frictions[i].follows_slip;
        i += 1;
    }
    i = 0;
    while i < layout.quantities.len() {
        has |= matches!(layout.quantities[i].kind, QuantityKind::DrivenDistance);
        i += 1;
    }
    has
}
