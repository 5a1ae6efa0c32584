//! The variables of a unit; the value reference of each is its place.

use crate::contact_state::ContactState;
use crate::error::FmuError;
use crate::guards::{Guard, exchange_lacks};
use liftoff::__private::expression::si_unit::{SECOND, SiUnit};
use liftoff_core::model::Layout;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{Entry, Units};

/// What a variable is.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// The independent variable.
    Time,
    /// A parameter, by its place in the layout.
    Parameter(usize),
    /// A coordinate or a rate, by its place in the state.
    State {
        /// Its place in the state.
        entry: usize,
        /// Whether its start is what is given; else it follows from what is given of the others,
        /// unless it is set.
        given: bool,
    },
    /// The derivative of a rate, by the place of the rate in the state.
    Acceleration(usize),
    /// An expression of the model's names.
    Output,
    /// The state of a contact, by its place in the layout.
    Contact(usize),
    /// How many events there have been since the start.
    Events,
    /// An event indicator.
    Guard(Guard),
}

/// A variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Its name: that of the thing in the model's language, `phi'`, `N(A)`.
    pub name: String,
    /// What it is.
    pub quantity: Quantity,
    /// It as an expression of the model's names, of what is read of a motion.
    pub expression: Option<String>,
    /// Its unit, where that is known.
    pub unit: Option<SiUnit>,
    /// Its value before anything is set, of parameters, coordinates and rates.
    pub start: Option<f64>,
}

/// What importers see of a model.
#[derive(Debug, Clone)]
pub struct Interface {
    /// The names of the model.
    pub layout: &'static Layout,
    /// The variables in the order of their value references.
    pub variables: Vec<Variable>,
    /// Why it is for co-simulation only, if it is.
    pub exchange_lacks: Option<&'static str>,
}

impl Interface {
    /// That of a model with the values that it has by default.
    ///
    /// # Errors
    /// Values that are missing, or from which the model cannot begin.
    pub fn from_model(model: &Entry, spec: &RunSpec) -> Result<Self, FmuError> {
        let layout = model.layout();
        let exchange_lacks = exchange_lacks(layout, spec);
        let guards = if exchange_lacks.is_none() { Guard::all(layout) } else { Vec::new() };
        let mut list = List { units: Units::from_layout(layout), variables: Vec::new() };
        list.push("time".to_owned(), Quantity::Time, Some(SECOND));
        list.parameters(layout, spec)?;
        list.states(model, spec)?;
        list.outputs(layout);
        for guard in guards {
            list.push(guard.name(layout), Quantity::Guard(guard), None);
        }
        Ok(Self { layout, variables: list.variables, exchange_lacks })
    }

    /// The value references of the derivatives of the states, in their order.
    pub fn derivatives(&self) -> Vec<u32> {
        let rates = self.layout.coordinates.len();
        self.references(|quantity| match quantity {
            Quantity::State { entry, .. } => *entry >= rates,
            quantity => matches!(quantity, Quantity::Acceleration(_)),
        })
    }

    /// The value references of all variables that are so.
    pub fn references(&self, is: impl Fn(&Quantity) -> bool) -> Vec<u32> {
        let found = self.variables.iter().zip(0..).filter(|(variable, _)| is(&variable.quantity));
        found.map(|(_, reference)| reference).collect()
    }
}

/// Variables, each with a name of its own.
struct List {
    units: Units,
    variables: Vec<Variable>,
}

impl List {
    fn push(&mut self, mut name: String, quantity: Quantity, unit: Option<SiUnit>) -> &mut Variable {
        while self.has(&name) {
            name.push('_');
        }
        self.variables.push(Variable { name, quantity, expression: None, unit, start: None });
        let last = self.variables.len() - 1;
        &mut self.variables[last]
    }

    fn has(&self, name: &str) -> bool {
        self.variables.iter().any(|variable| variable.name == name)
    }

    fn parameters(&mut self, layout: &Layout, spec: &RunSpec) -> Result<(), FmuError> {
        for (i, name) in layout.parameters.iter().enumerate() {
            let value = spec.parameters.iter().rev().find(|(given, _)| given == name);
            let (_, value) = value.ok_or_else(|| FmuError::Parameter((*name).to_owned()))?;
            let unit = self.units.si(name);
            self.push((*name).to_owned(), Quantity::Parameter(i), unit).start = Some(*value);
        }
        Ok(())
    }

    /// Coordinates, rates and accelerations.
    fn states(&mut self, model: &Entry, spec: &RunSpec) -> Result<(), FmuError> {
        let simulation = model.simulation(spec).map_err(|error| FmuError::Model(error.to_string()))?;
        let start = simulation.start_state().map_err(|error| FmuError::Model(error.to_string()))?;
        let layout = model.layout();
        let names = layout.coordinates.iter().map(|coordinate| coordinate.name);
        let n = names.len();
        let is_given = |name: &str| spec.start.iter().any(|(given, _)| given == name);
        for order in 0..3 {
            for (i, name) in names.clone().enumerate() {
                let primes = "'".repeat(order);
                let name = format!("{name}{primes}");
                let entry = order * n + i;
                let mut following = layout
                    .dependent
                    .iter()
                    .filter(|angle| angle.coordinates.iter().any(|term| term.index == i));
                let given =
                    is_given(&name) || following.any(|angle| is_given(&format!("{}{primes}", angle.name)));
                let quantity = match order {
                    2 => Quantity::Acceleration(entry - n),
                    _ => Quantity::State { entry, given },
                };
                let unit = self.units.si(&name);
                let variable = self.push(name.clone(), quantity, unit);
                variable.start = start.get(entry).copied().filter(|_| order < 2);
                variable.expression = Some(name);
            }
        }
        Ok(())
    }

    /// Reactions, friction, gaps, energies, joint forces and what else the model has; states of
    /// contacts; the count of events.
    fn outputs(&mut self, layout: &'static Layout) {
        for (i, contact) in layout.contacts.iter().enumerate() {
            self.push(format!("contact({})", contact.label), Quantity::Contact(i), None);
        }
        let of_contacts = layout.contacts.iter().flat_map(|contact| {
            let one = contact.supports[0];
            let normal = Some(format!("N({})", contact.label));
            let friction = contact.has_friction_force().then(|| format!("R({})", contact.label));
            let slip = contact.friction.map(|_| format!("v({one})"));
            let gap = (!contact.is_hinge()).then(|| format!("gap({one})"));
            [normal, friction, slip, gap].into_iter().flatten()
        });
        let quantities = layout.quantities.iter().map(|quantity| quantity.name.to_owned());
        let energies = ["T", "V", "E"].map(str::to_owned);
        for name in of_contacts.chain(energies).chain(quantities) {
            if !self.has(&name) && liftoff::Output::parse(layout, &name).is_ok() {
                let unit = self.units.si(&name);
                let expression = Some(name.clone());
                self.push(name, Quantity::Output, unit).expression = expression;
            }
        }
        self.push("events".to_owned(), Quantity::Events, None);
    }
}

impl Quantity {
    /// Whether importers read it as an integer: of an enumeration, or a count.
    pub fn is_integer(&self) -> bool {
        matches!(self, Self::Contact(_) | Self::Events)
    }

    /// Whether it is an output of the unit.
    pub fn is_output(&self) -> bool {
        matches!(self, Self::State { .. } | Self::Output | Self::Contact(_) | Self::Events)
    }
}

/// The values of the enumeration of contacts.
pub(crate) fn contact_states() -> impl Iterator<Item = (&'static str, i64)> {
    ContactState::ALL.into_iter().map(|state| (state.name(), state as i64))
}
