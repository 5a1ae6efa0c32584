//! Contacts, springs, loads and drives that are there while a condition holds: `while("phi > 0")`.

use smallvec::smallvec;

use crate::error::ModelError;
use crate::expression::{Condition, Variable};
use crate::integration::phase_point::{Numbers, PhasePoint, RunContext};
use crate::model::{ContactSet, Form, Layout, QuantityKind};

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
    /// All of a model.
    pub(crate) fn all(layout: &'static Layout) -> Result<Vec<Self>, ModelError> {
        let contacts = layout.contacts.iter().enumerate();
        let contacts = contacts.filter_map(|(i, contact)| Some((Switched::Contact(i), contact.armed?)));
        let loads = layout.switches.iter().enumerate();
        let loads = loads.map(|(i, switch)| (Switched::Loads(i), switch.condition));
        let read = |(switched, text): (Switched, &str)| {
            let armed = Condition::parse(layout, text)
                .map_err(|source| ModelError::Switch { of: switched.label(layout).to_owned(), source })?;
            if armed.reads().iter().any(|variable| is_decided_after(layout, *variable)) {
                return Err(ModelError::SwitchedByForce { of: switched.label(layout).to_owned() });
            }
            let disarmed = armed.negated();
            Ok(Self { switched, conditions: [armed, disarmed] })
        };
        contacts.chain(loads).map(read).collect()
    }

    /// Its contact.
    pub(crate) fn contact(&self) -> Option<usize> {
        if let Switched::Contact(i) = self.switched { Some(i) } else { None }
    }
}

/// Whether a variable is known only once it is decided which contacts and drives bear.
fn is_decided_after(layout: &Layout, variable: Variable) -> bool {
    use QuantityKind::{DriveForce, DriveTorque};
    match variable {
        Variable::Reaction(_) | Variable::Friction(_) | Variable::Coefficient(_) => true,
        Variable::Quantity(i) => matches!(layout.quantities[i].kind, DriveForce | DriveTorque),
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

impl RunContext {
    /// The contacts that are not there at a state.
    pub(crate) fn disarmed(&self, state: &[f64], t: f64) -> ContactSet {
        self.away(state, t).into_iter().filter_map(|away| Switch::contact(&self.switches[away])).collect()
    }

    /// Lets the springs and loads act whose conditions hold at a state, and no others.
    pub(crate) fn set_switches(&self, state: &mut [f64], t: f64) {
        let layout = self.layout();
        for switch in 0..layout.switches.len() {
            state[layout.switch(switch)] = 1.0;
        }
        for away in self.away(state, t) {
            if let Switched::Loads(switch) = self.switches[away].switched {
                state[layout.switch(switch)] = 0.0;
            }
        }
    }

    /// The switches whose conditions do not hold at a state.
    fn away(&self, state: &[f64], t: f64) -> Vec<usize> {
        if self.switches.is_empty() {
            return Vec::new();
        }
        let phase = self.phase(ContactSet::EMPTY, Form::Projected);
        let mut reduced: Numbers = smallvec![0.0; phase.info().entries];
        phase.restrict(state, &mut reduced);
        let point = PhasePoint::new(phase, ContactSet::EMPTY, t, reduced);
        let holds = |i: &usize| self.switches[*i].conditions[0].holds(self, &point);
        (0..self.switches.len()).filter(|i| !holds(i)).collect()
    }

    /// The contacts that come and go.
    pub(crate) fn switched(&self) -> ContactSet {
        self.switches.iter().filter_map(Switch::contact).collect()
    }

    /// A state in which what is switched acts as in another.
    pub(crate) fn switched_as(&self, state: &[f64], other: &[f64]) -> Numbers {
        let mut switched: Numbers = state.into();
        let switches = self.layout().switch(0);
        switched[switches..].copy_from_slice(&other[switches..]);
        switched
    }
}
