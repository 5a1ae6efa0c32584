//! Contacts that are there while a condition holds: `while("phi > 0")`.

use smallvec::smallvec;

use crate::error::ModelError;
use crate::expression::Condition;
use crate::integration::phase_point::{Numbers, PhasePoint, RunContext};
use crate::model::{ContactSet, Form, Layout};

/// A contact with the conditions on which it comes and goes.
#[derive(Debug, Clone)]
pub(crate) struct Switch {
    pub(crate) contact: usize,
    /// What arms it, and what disarms it.
    pub(crate) conditions: [Condition; 2],
}

impl Switch {
    /// All of a model.
    pub(crate) fn all(layout: &'static Layout) -> Result<Vec<Self>, ModelError> {
        let declared =
            layout.contacts.iter().enumerate().filter_map(|(i, contact)| Some((i, contact.armed?)));
        let read = |(contact, text): (usize, &str)| {
            let armed = Condition::parse(layout, text).map_err(|source| {
                let contact = layout.contacts[contact].label.to_owned();
                ModelError::Switch { contact, source }
            })?;
            let disarmed = armed.negated();
            Ok(Self { contact, conditions: [armed, disarmed] })
        };
        declared.map(read).collect()
    }
}

impl RunContext {
    /// The contacts that are not there at a state.
    pub(crate) fn disarmed(&self, state: &[f64], t: f64) -> ContactSet {
        if self.switches.is_empty() {
            return ContactSet::EMPTY;
        }
        let phase = self.phase(ContactSet::EMPTY, Form::Projected);
        let mut reduced: Numbers = smallvec![0.0; phase.info().entries];
        phase.restrict(state, &mut reduced);
        let point = PhasePoint::new(phase, ContactSet::EMPTY, t, reduced);
        let away = self.switches.iter().filter(|switch| !switch.conditions[0].holds(self, &point));
        away.map(|switch| switch.contact).collect()
    }

    /// The contacts that come and go.
    pub(crate) fn switched(&self) -> ContactSet {
        self.switches.iter().map(|switch| switch.contact).collect()
    }
}
