//! What a declaration says of the course of a run: what comes and goes, which functions of time it
//! follows, where it ends.

use super::Domain;
use crate::context::RunContext;
use crate::error::ModelError;
use crate::event::detection::Signal;
use crate::expression::Switches;

/// Conditions and functions of time of a model.
#[derive(Default)]
pub(crate) struct Rules {
    /// What is there while a condition holds.
    pub(crate) switches: Switches,
    /// The functions of time that loads and drives follow.
    pub(crate) signals: Vec<Signal>,
    /// Where the equations hold.
    pub(crate) domains: Vec<Domain>,
}

impl Rules {
    /// Those of a model; refuses switches that depend on reactions, and bounds that its figure is
    /// beyond.
    pub(crate) fn from_model(context: &RunContext) -> Result<Self, ModelError> {
        let layout = context.layout();
        let domains = Domain::all(layout);
        let rules = Self { switches: Switches::from_layout(layout)?, signals: Signal::all(layout), domains };
        rules.domains.iter().try_for_each(|domain| domain.check(context))?;
        Ok(rules)
    }
}
