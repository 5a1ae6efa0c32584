//! Where a motion is looked at once a turn.

use core::fmt;

use liftoff::EventFilter;
use liftoff::{Condition, EventKind, Simulation, Trajectory};
use liftoff_core::model::Layout;
use liftoff_core::scalar::Dual4;
use liftoff_core::system::ModelOn;
use liftoff_replay::difference;

use super::OrbitError;

/// A surface in the space of states.
#[derive(Debug, Clone, PartialEq)]
pub enum Section {
    /// An event, and the state behind it.
    Event(EventFilter),
    /// A condition that becomes true, `phi > 0` for a crossing upward, `phi = 0` for any; of a
    /// driven model `t = T`, the period of its drive.
    Condition(Condition),
}

impl Section {
    /// Reads `impact`, `impact A`, or a condition, with the names of a model.
    ///
    /// # Errors
    /// It is neither; there is no such support.
    pub fn parse(layout: &'static Layout, text: &str) -> Result<Self, OrbitError> {
        let mut words = text.split_whitespace();
        let first = words.next();
        let kind = EventKind::ALL.into_iter().find(|kind| first == Some(kind.name()));
        if let (Some(kind), support, None) = (kind, words.next(), words.next()) {
            return Ok(Self::Event(EventFilter::new(layout, kind, support)?));
        }
        let condition = Condition::parse(layout, text);
        condition.map(Self::Condition).map_err(|why| OrbitError::Section { text: text.to_owned(), why })
    }

    /// The same simulation, ended at the section.
    pub(super) fn end(&self, simulation: Simulation) -> Result<Simulation, OrbitError> {
        match self {
            Self::Event(filter) => Ok(simulation.until_event(filter.kind, filter.support)?),
            Self::Condition(condition) => {
                let text = condition.to_string();
                simulation.until(&text).map_err(|why| OrbitError::Section { text, why })
            }
        }
    }

    /// The time that it names with these parameters, where it is nothing else.
    pub(super) fn time(&self, parameters: &[f64]) -> Option<f64> {
        if let Self::Condition(condition) = self { condition.time(parameters) } else { None }
    }

    /// h at a full state of a condition h > 0, h < 0 or h = 0 on positions and rates; events have
    /// none, nor do other conditions.
    pub(super) fn height(&self, model: &ModelOn<Dual4>, state: &[Dual4]) -> Option<Dual4> {
        if let Self::Condition(condition) = self { difference(condition, model, state) } else { None }
    }

    /// Whether a run has come to it.
    pub(super) fn has_ended(&self, run: &Trajectory) -> bool {
        let mut last = run.events().iter().rev().take_while(|event| event.t == run.end_time());
        last.any(|event| match self {
            Self::Event(filter) => filter.is(event),
            Self::Condition(_) => event.kind == EventKind::Stop,
        })
    }
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Event(filter) => filter.fmt(f),
            Self::Condition(condition) => condition.fmt(f),
        }
    }
}
