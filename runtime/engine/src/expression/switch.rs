//! Contacts, springs, loads and drives that are there while a condition holds: `while("phi > 0")`.

use core::ops::Deref;

use super::{Condition, Variable};
use crate::context::{RunContext, reduce};
use crate::error::ModelError;
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Form, Layout};

/// What comes and goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Switched {
    /// A contact.
    Contact(usize),
    /// Springs and loads, by their entry in [`Layout::switches`].
    Loads(usize),
}

/// What comes and goes, with its conditions.
#[derive(Debug, Clone)]
pub(crate) struct Switch {
    pub(crate) switched: Switched,
    /// What arms it, and what disarms it.
    pub(crate) conditions: [Condition; 2],
}

impl Switch {
    fn parse(layout: &'static Layout, switched: Switched, text: &str) -> Result<Self, ModelError> {
        let armed = Condition::parse(layout, text)
            .map_err(|source| ModelError::Switch { of: switched.label(layout).to_owned(), source })?;
        if armed.reads().iter().any(|variable| is_decided_after(layout, *variable)) {
            return Err(ModelError::SwitchedByForce { of: switched.label(layout).to_owned() });
        }
        let disarmed = armed.negated();
        Ok(Self { switched, conditions: [armed, disarmed] })
    }

    /// Its contact.
    pub(crate) fn contact(&self) -> Option<usize> {
        if let Switched::Contact(i) = self.switched { Some(i) } else { None }
    }
}

/// Whether a variable is known only once it is decided which contacts bear.
fn is_decided_after(layout: &Layout, variable: Variable) -> bool {
    match variable {
        Variable::Reaction(_) | Variable::Friction(_) | Variable::Coefficient(_) => true,
        Variable::Quantity(i) => !layout.quantities[i].kind.is_of_state(),
        _ => false,
    }
}

impl Switched {
    /// What it is called.
    pub(crate) fn label(self, layout: &'static Layout) -> &'static str {
        match self {
            Self::Contact(i) => layout.contacts[i].label,
            Self::Loads(i) => layout.switches[i].label,
        }
    }
}

/// All switches of a model.
#[derive(Debug, Clone, Default)]
pub(crate) struct Switches(Vec<Switch>);

impl Switches {
    pub(crate) fn from_layout(layout: &'static Layout) -> Result<Self, ModelError> {
        let contacts = layout.contacts.iter().enumerate();
        let contacts = contacts.filter_map(|(i, contact)| Some((Switched::Contact(i), contact.armed?)));
        let loads = layout.switches.iter().enumerate();
        let loads = loads.map(|(i, switch)| (Switched::Loads(i), switch.condition));
        let all = contacts.chain(loads).map(|(switched, text)| Switch::parse(layout, switched, text));
        all.collect::<Result<_, _>>().map(Self)
    }

    /// The contacts that are not there at a state.
    pub(crate) fn disarmed(&self, context: &RunContext, state: &[f64], t: f64) -> ContactSet {
        self.away(context, state, t).into_iter().filter_map(|away| self.0[away].contact()).collect()
    }

    /// Lets the springs and loads act whose conditions hold at a state, and no others.
    pub(crate) fn set(&self, context: &RunContext, state: &mut [f64], t: f64) {
        let layout = context.layout();
        for switch in 0..layout.switches.len() {
            state[layout.switch(switch)] = 1.0;
        }
        for away in self.away(context, state, t) {
            if let Switched::Loads(switch) = self.0[away].switched {
                state[layout.switch(switch)] = 0.0;
            }
        }
    }

    /// The switches whose conditions do not hold at a state.
    fn away(&self, context: &RunContext, state: &[f64], t: f64) -> Vec<usize> {
        if self.0.is_empty() {
            return Vec::new();
        }
        let phase = context.phase(ContactSet::EMPTY, Form::Multipliers);
        let reduced = reduce(&*phase, state);
        let point = PhasePoint::new(phase, ContactSet::EMPTY, t, reduced);
        let holds = |i: &usize| self.0[*i].conditions[0].holds(context, &point);
        (0..self.0.len()).filter(|i| !holds(i)).collect()
    }
}

impl Deref for Switches {
    type Target = [Switch];

    fn deref(&self) -> &[Switch] {
        &self.0
    }
}
