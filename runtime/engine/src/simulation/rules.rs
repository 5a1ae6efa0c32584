//! What a declaration says of the course of a run: what comes and goes, which functions of time it
//! follows, where it ends.

use super::Domain;
use super::schedule::{Action, Scheduled, Trigger};
use crate::context::RunContext;
use crate::error::ModelError;
use crate::event::detection::Signal;
use crate::expression::{Condition, Switches};
use crate::model::Layout;

/// Conditions and functions of time of a model.
#[derive(Default)]
pub(crate) struct Rules {
    /// What is there while a condition holds.
    pub(crate) switches: Switches,
    /// What breaks.
    pub(crate) breaks: Vec<Scheduled>,
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
        let (switches, signals) = (Switches::from_layout(layout)?, Signal::all(layout));
        let rules = Self { switches, breaks: find_breaks(layout)?, signals, domains };
        rules.domains.iter().try_for_each(|domain| domain.check(context))?;
        Ok(rules)
    }
}

/// The removal of what breaks; contacts with one condition break together, as a pin does.
fn find_breaks(layout: &'static Layout) -> Result<Vec<Scheduled>, ModelError> {
    let contacts = layout.contacts;
    let breaking = |text| {
        let all = contacts.iter().enumerate().filter(move |(_, contact)| contact.breaks == text);
        all.map(|(i, _)| i)
    };
    let firsts = contacts.iter().enumerate().filter_map(|(i, first)| {
        let text = first.breaks?;
        (breaking(Some(text)).next() == Some(i)).then_some((first.label, text))
    });
    let removal = |(label, text): (&str, &'static str)| {
        let condition = Condition::parse(layout, text)
            .map_err(|source| ModelError::Break { of: label.to_owned(), source })?;
        let action = Action::Remove(breaking(Some(text)).collect());
        Ok(Scheduled { action, when: Trigger::If(condition) })
    };
    firsts.map(removal).collect()
}
