//! Events that are waited for or looked up: of a kind, and to a support.

use core::fmt;

use crate::error::SupportError;
use crate::event::{Event, EventKind};
use crate::expression::resolve::unknown_support;
use crate::model::Layout;
use crate::model::names::ContactFilter;

/// An event of a kind, to one support or to any.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EventFilter {
    /// The kind.
    pub kind: EventKind,
    /// The support; none for any.
    pub support: Option<&'static str>,
}

impl EventFilter {
    /// Of this kind, to a support of the model, or to any with `None`.
    ///
    /// # Errors
    /// The model has no such support.
    pub fn new(
        layout: &'static Layout,
        kind: EventKind,
        support: impl ContactFilter,
    ) -> Result<Self, SupportError> {
        let Some(name) = support.contact() else { return Ok(Self { kind, support: None }) };
        let mut supports = layout.contacts.iter().flat_map(|contact| contact.supports.iter().copied());
        match supports.find(|known| *known == name) {
            Some(known) => Ok(Self { kind, support: Some(known) }),
            None => Err(unknown_support(layout, name).into()),
        }
    }

    /// Whether this event is one.
    pub fn is(&self, event: &Event) -> bool {
        event.kind == self.kind && self.support.is_none_or(|support| event.supports.contains(&support))
    }
}

impl fmt::Display for EventFilter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.support {
            Some(support) => write!(f, "{} {support}", self.kind),
            None => write!(f, "{}", self.kind),
        }
    }
}
